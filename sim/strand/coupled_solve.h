#pragma once
/// Direct solve of the strand's banded matrix plus couplings between far-apart nodes (thread against thread) and with hands that give way
/// to it, a block each. The nodes that touch are the core. The free stretches between them are eliminated along the band, in linear time,
/// whatever the length of a loop; what remains is a small matrix over the core, ordered so that strands lying along each other stay
/// neighbours (reverse Cuthill-McKee; the hands, which couple with many, come last) and factored directly (sim/strand/envelope.h). Exact,
/// no iteration, no heap after `resize`.
#include <vector>

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
  bool coupleHand(int hand, int node);         // and a hand with three nodes; false when the core is full
  bool closeStructure();                       // false when the envelope would not fit
  bool empty() const { return core_.empty(); }
  int coreNodes() const { return static_cast<int>(core_.size()); }
  bool holdsHand(int hand) const { return inCore_[handBlock(hand)] != 0; }
  int handBlock(int hand) const { return blocks_ + hand; }   // what `add` calls a hand

  /// Values: of the couplings only; the band is the strand's own.
  void clearValues();
  void add(int nodeI, int nodeJ, const Mat3& block);   // [N/m] a symmetric block, once for each pair

  /// x := (band + couplings)^-1 x, the hands' three unknowns each behind the strand's; those of a hand that was not coupled stay. The band
  /// is used up. False when a pivot is not positive.
  bool solve(BandedMatrix& band, double* x);   // [N] then [m]

 private:
  int width(int block) const { return 3 * (block + 1 - first_[block]); }
  void findStretches();
  void linkNeighbours();
  void orderCore();
  int handsHeld() const;
  bool enter(int block);                       // into the core, if there is room
  bool enterThree(int node);                   // a contact's
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
  void solveCore(double* x, double* hands);    // [N] then [m]

  int blocks_ = 0;                             // of the band: the needle counts as two more; behind them the hands'
  std::vector<char> inCore_;                   // per block, hands' too
  std::vector<int> core_, place_, first_, offset_;   // core: block of each place; place: of each block, -1 outside
  std::vector<char> graph_;                    // kMaxCore rows: which places of the core couple
  std::vector<int> degree_, order_;            // of each place; the order in which places are eliminated
  std::vector<std::pair<int, int>> pairs_, handPairs_;   // of first nodes; of a hand and a first node
  std::vector<Stretch> stretches_;
  std::vector<double> border_;                 // [N/m] StretchBand::kBorder per scalar row: coupling with the core before the stretch
  std::vector<double> envelope_, values_;      // [N/m] factored; couplings as added
  std::vector<double> x_;                      // [N] then [m]; zeros behind its end
  std::vector<double> coreX_, scaled_, inverse_;   // [N] then [m]; three rows abreast, times the pivots; [m/N]
};

}  // namespace halsted
