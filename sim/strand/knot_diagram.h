#pragma once
/// What was tied, read from the thread's own course: its smooth curve (thread_curve.h) is joined into fewer, straighter pieces wherever no
/// other piece passes between (Koniaris and Muthukumar 1991), the rest is projected, its crossings with signs are read along the thread, and
/// the diagram is reduced by Reidemeister's first and second moves. A knot drawn tight shows crossings too many in almost every view; where
/// none can be read the corners are drawn in, as far as nothing is in their way, and it is looked at again. A throw is a run of an odd
/// number of crossings of one sign that both strands pass in the same order: 3 for one turn, 5 for a surgeon's double. Throws that enclose
/// one another were tied on the same loop, innermost first; opposite signs lie square (=), equal signs make a granny (x).
/// The two ends are led straight away from the middle of the thread. No libm; a `KnotReader` takes no heap once made.
#include <array>
#include <span>
#include <string>
#include <vector>

#include "sim/types.h"

namespace halsted {

/// One passage of the thread through a crossing.
struct CrossingVisit { int crossing; bool over; };

struct KnotDiagram {
  std::vector<CrossingVisit> code;             // along the thread: each crossing twice, once over and once under
  std::vector<int> sign;                       // per crossing, +1 or -1
  int crossings() const { return static_cast<int>(code.size()) / 2; }
};

/// One throw: turns of one strand round the other, 1 single, 2 double; the sign of its crossings.
struct Throw { int turns, sign; };

/// Throws in the order in which they were tied.
class ThrowList {
 public:
  static constexpr std::size_t kMost = 12;     // what lies beyond is counted as left over
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const Throw& operator[](std::size_t i) const { return item_[i]; }
  const Throw* begin() const { return item_.data(); }
  const Throw* end() const { return item_.data() + count_; }
  bool add(const Throw& t) { return count_ < kMost && (item_[count_++] = t, true); }

 private:
  std::array<Throw, kMost> item_{};
  std::size_t count_ = 0;
};

struct KnotReading {
  ThrowList throws;
  bool complete = false;                       // all crossings belong to throws on one loop
  int crossingsLeft = 0;                       // that belong to no throw
};

/// Crossings seen along `direction`.
KnotDiagram projectThread(std::span<const Vec3> curve, const Vec3& direction);   // [m]

/// Reidemeister's moves one and two, until none is left.
void reduceDiagram(KnotDiagram&);

/// Takes the throws out of a reduced diagram, innermost first, and each crossing that went round nothing else; leaves what belongs to none.
KnotReading takeThrows(KnotDiagram&);

/// |Alexander polynomial at -1| of the thread closed far away: 3 for a throw, 9 for square and granny, 5 for a double throw. 0 when a
/// diagram of more than 60 crossings is refused.
long long knotDeterminant(const KnotDiagram&);

/// The thread's curve with every point left out that no other piece holds in place; ends led away.
std::vector<Vec3> straightened(std::span<const Vec3> nodes);   // [m]

KnotReading readKnot(std::span<const Vec3> nodes);   // [m]

/// Reads again and again without the heap.
class KnotReader {
 public:
  static constexpr int kMostCrossings = 1200;  // in one view; what is more tangled is not read
  struct Visit { double along; CrossingVisit visit; };   // [1] piece of the straightened thread + share

  KnotReader() = default;
  explicit KnotReader(int nodes);              // the longest thread that may be read
  KnotReading read(std::span<const Vec3> nodes);   // [m]

 private:
  friend std::vector<Vec3> straightened(std::span<const Vec3> nodes);   // [m]
  void sampleCurve(std::span<const Vec3> nodes);   // [m]
  void straighten(std::span<const Vec3> nodes);   // [m]
  void drawIn();                               // moves corners of what is straightened
  void lookFrom(int views, KnotReading& best, int& fewest);
  bool project(const Vec3& direction);         // [1] false: more crossings than fit

  std::vector<Vec3> straight_, seen_;          // [m]
  std::vector<Visit> visits_;
  KnotDiagram diagram_;
};

/// As surgeons write it: "1", "1=1", "1x1", "2=1=1"; empty when nothing is tied; "?" added when crossings are left over.
std::string surgicalNotation(const KnotReading&);
/// "half hitch", "square", "granny", "surgeon's", or the notation.
std::string knotName(const KnotReading&);

}  // namespace halsted
