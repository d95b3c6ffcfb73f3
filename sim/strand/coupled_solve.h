#pragma once
/// Direct solve of the strand's banded matrix plus couplings between far-apart nodes (thread against thread).
/// The nodes that touch are the core. The free stretches between them are eliminated along the band, in linear time, whatever the length
/// of a loop; what remains is a small matrix over the core, ordered so that strands lying along each other stay neighbours (reverse
/// Cuthill-McKee) and factored directly (sim/strand/envelope.h). Exact, no iteration, no heap after
/// `resize`.
#include <span>
#include <vector>

#include "sim/lanes.h"
#include "sim/strand/banded.h"
#include "sim/strand/envelope.h"
#include "sim/strand/stretch.h"
#include "sim/types.h"

namespace halsted {

class CoupledSolve {
 public:
  static constexpr int kMaxCore = 400;         // nodes that touch at once; `couple` refuses more
  static constexpr std::size_t kMaxPairs = 8192;   // of three-node groups
  static constexpr int kMaxEnvelope = 900000;  // scalars in the envelope

  void resize(int threadNodes);

  /// Structure: forget all, then name each pair of three-node groups that a contact may couple, then close.
  void clearStructure();
  bool couple(int nodeA, int nodeB);           // false when the core is full
  bool closeStructure();                       // false when the envelope would not fit
  bool empty() const { return core_.empty(); }
  int coreNodes() const { return static_cast<int>(core_.size()); }

  /// Values: of the couplings only; the band is the strand's own.
  void clearValues();
  void add(int nodeI, int nodeJ, const Mat3& block);   // [N/m] a symmetric block, once for each pair

  /// x := (band + couplings)^-1 x, and the same for `more`, at most two columns of three right-hand sides with BandedMatrix::kHalf rows of
  /// zeros behind; what their fourth lanes hold is lost. The band is used up. False when a pivot is not positive.
  bool solve(BandedMatrix& band, double* x, std::span<Lanes4* const> more = {});   // [N] then [m]

 private:
  int width(int block) const { return 3 * (block + 1 - first_[block]); }
  void findStretches();
  void linkNeighbours();
  void orderCore();
  void connect(int nodeI, int nodeJ);          // within the core's graph, by present places
  StretchBand beginBorders(BandedMatrix&);
  struct CoreBlock {
    double* begin;                             // [N/m]
    int row, column;                           // how far the next of each lies
    double& at(int r, int c) const { return begin[r * row + c * column]; }
  };
  CoreBlock coreBlock(std::vector<double>& entries, int nodeI, int nodeJ) const;   // [N/m]
  void gatherCore(const StretchBand&);
  Envelope core();                             // its matrix
  void solveCore(double* x);                   // [N] then [m]
  void solveCoreFour(double* x);               // [N] then [m], rows of four
  void substituteAll(const StretchBand&, double* x, std::span<Lanes4* const> more);   // [N] then [m]

  int nodes_ = 0, blocks_ = 0;                 // blocks: the needle counts as two more
  std::vector<char> inCore_;                   // per block
  std::vector<int> core_, place_, first_, offset_;   // core: block of each place; place: of each block, -1 outside
  std::vector<char> graph_;                    // kMaxCore rows: which places of the core couple
  std::vector<int> degree_, order_;            // of each place; the order in which places are eliminated
  std::vector<std::pair<int, int>> pairs_;
  std::vector<Stretch> stretches_;
  std::vector<double> border_;                 // [N/m] StretchBand::kBorder per scalar row: coupling with the core before the stretch
  std::vector<double> envelope_, values_;      // [N/m] factored; couplings as added
  std::vector<double> x_;                      // [N] then [m]; zeros behind its end
  std::vector<double> coreX_, scaled_, inverse_;   // [N] then [m], room for four; three rows abreast, times the pivots; [m/N]
};

}  // namespace halsted
