#include "sim/suture/fresh_thread.h"

#include <algorithm>

#include "sim/contact/geometry.h"
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"
#include "sim/suture/knotting.h"
#include "sim/suture/stitch_course.h"
#include "sim/suture/tied_loop.h"
#include "sim/tools/come_free.h"
#include "sim/tools/instrument.h"
#include "sim/tools/load_driver.h"
#include "sim/tools/tool_shape.h"

namespace halsted {
namespace {

constexpr double kFree = 6e-3;                 // [m] between the new thread and whatever else there is

const Hole& firstHole(const State& s) { return s.strand.holes[0]; }
const Hole& lastHole(const State& s) { return s.strand.holes[s.strand.holeCount - 1]; }

/// Would thread that hangs from here lie in the wall, or in a tool?
bool inTheWay(const Model& m, const State& s) {
  const ToolState& driver = s.tools[kRight];
  const Vec3 swage = driver.proxy.apply(loadedNeedle(m.strand).apply(m.strand.arcPoint.front()));
  const Vec3& tip = driver.proxy.position;
  if (tissueWithin(m, s, {swage, swage - Vec3(0.0, m.strand.length, 0.0), kFree})) return true;
  if (tissueWithin(m, s, {tip, tip, 2.0 * m.strand.needle.radius + kFree})) return true;
  const ToolState& other = s.tools[kLeft];
  const Vec3 hinge = other.proxy.apply(Vec3(0.0, 0.0, toolOf(m, s, kLeft).jawLength)), shaft = hinge - other.proxy.position;   // [m]
  for (int i = 0; i < m.strand.nodes; ++i) {
    const Vec3 p = swage - Vec3(0.0, lengthAfter(m.strand, i), 0.0);
    if ((p - other.proxy.position - closestOnSegment(p, other.proxy.position, hinge) * shaft).squaredNorm() < kFree * kFree) return true;
  }
  return false;
}

ThreadRefusal refusal(const Model& m, const State& s) {
  const bool stitch = s.strand.holeCount > 0;
  if (s.supply->left < 1) return ThreadRefusal::kNoneLeft;
  if (toolOf(m, s, kRight).kind != ToolKind::kNeedleDriver) return ThreadRefusal::kNoDriver;
  if (!jawsEmpty(s.tools[kLeft]) || !jawsEmpty(s.tools[kRight])) return ThreadRefusal::kHandsFull;
  if (stitch && !finishedLoop(m, s)) return ThreadRefusal::kNotTied;
  if (stitch && (s.strand.holeCount > TiedStitch::kMostHoles || s.stitches->count == TiedStitches::kMost)) return ThreadRefusal::kNoRoom;
  if (inTheWay(m, s)) return ThreadRefusal::kInTheWay;
  return ThreadRefusal::kNone;
}

/// The tied loop goes on as a stitch of its own, through the same holes and with the same pull; one that is loose, with the same slack.
void keepStitch(const Model& m, State& s, StepOutput& out) {
  const std::optional<TiedLoop> loop = finishedLoop(m, s);
  if (!loop) return;
  std::array<TissuePoint, TiedStitch::kMostHoles> holes;
  const int count = s.strand.holeCount;
  for (int i = 0; i < count; ++i) holes[i] = placeOf(s.strand.holes[i]);
  if (!tieStitch(m, s, {holes.data(), static_cast<std::size_t>(count)}, loop->tip - loop->tail)) return;
  TiedStitch& stitch = s.stitches->stitch[s.stitches->count - 1];
  if (isTaut(m, s, *loop)) loadStitch(m, s.tissue.position, loopTension(m, s, *loop), stitch);
  else stitch.length = loopLength(m, stitch, s.tissue.position) + loopSlack(m, s, *loop);   // as it runs from now on: straight from hole to hole
  keepCourse(m, s, *loop, stitch);
  pushEvent(out, {s.step, EventKind::kStitchFinished, -1, s.stitches->count, stitch.length});
}

/// Nothing is left of the old thread.
void layFreshThread(const Model& m, State& s) {
  layAtRest(m.strand, loadDriver(m, s.tools[kRight]), s.strand);
  for (int hand = 0; hand < kHands; ++hand) {
    ToolState& t = s.tools[hand];
    comeFree(m, hand, t.needleForce + t.threadForce + t.strandForce, t);
    t.needleForce = t.threadForce = t.strandForce = Vec3::Zero();
  }
  s.threadContacts.count = 0;
  std::fill(s.threadContacts.drag.begin(), s.threadContacts.drag.end(), 0.0);
  std::fill(s.threadContacts.set.begin(), s.threadContacts.set.end(), Vec3::Zero());
  std::fill(s.threadContacts.cut.begin(), s.threadContacts.cut.end(), std::uint8_t{0});
  s.knot = KnotState{};
  s.knot.watched = true;
  if (!s.assist) return;
  AssistKnot next;
  next.locks = s.assist->locks;
  next.slipped = s.assist->slipped;
  *s.assist = next;
}

void countAnew(State& s) {
  ThreadSupply& supply = *s.supply;
  --supply.left;
  ++supply.handed;
  supply.bitesBefore = s.metrics.biteCount;
  supply.tearsBefore = s.metrics.tears;
  if (!s.metrics.seam) return;
  supply.fullThicknessBefore = s.metrics.seam->fullThickness;
  s.metrics.seam->deepestTip = 0.0;
}

}  // namespace

int finishedStitches(const Model& m, const State& s) {
  const auto bowel = [&](int tet) { return m.bowels.of[m.tissue.tets[tet][0]]; };
  int joining = 0;
  for (int k = 0; s.stitches && k < s.stitches->count; ++k) {
    const TiedStitch& stitch = s.stitches->stitch[k];
    joining += m.bowels.count < 2 || bowel(stitch.hole[0].tet) != bowel(stitch.hole[stitch.holeCount - 1].tet);
  }
  if (!finishedLoop(m, s)) return joining;
  return joining + (m.bowels.count < 2 || bowel(firstHole(s).tet) != bowel(lastHole(s).tet));
}

void handFreshThread(const Model& m, State& s, StepOutput& out) {
  if (!s.supply || !s.stitches) return;
  const ThreadRefusal why = refusal(m, s);
  s.supply->refusal = static_cast<std::int32_t>(why);
  if (why != ThreadRefusal::kNone) {
    pushEvent(out, {s.step, EventKind::kThreadRefused, kRight, s.supply->refusal, 0.0});
    return;
  }
  keepStitch(m, s, out);
  layFreshThread(m, s);
  countAnew(s);
  pushEvent(out, {s.step, EventKind::kThreadHanded, kRight, s.supply->left, 0.0});
}

}  // namespace halsted
