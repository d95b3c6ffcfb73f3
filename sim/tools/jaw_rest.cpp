#include "sim/tools/jaw_rest.h"

#include <cmath>

#include "sim/portable_math.h"
#include "sim/strand/strand.h"
#include "sim/suture/knotting.h"
#include "sim/tools/instrument.h"

namespace halsted {
namespace {

constexpr double kClosing = 8.0;               // [N] of one jaw on a strand across it: what its grip holds (design)
constexpr double kDeep = 7e-3;                 // [m] from the tips along the jaws: farther up thread may be cut or slip past the hinge
constexpr int kPerSegment = 4;                 // places looked at in each segment of the thread

/// Between the middle line and one jaw's inner face, fully open, at this height over the tips.  [m]
double openedTo(const ToolParams& p, double height) {   // [m]
  constexpr double kHalfDegree = kPi / 360.0;  // half the angle between the jaws, small enough to be its tangent [rad]
  return p.jawAngleDegrees * kHalfDegree * (p.jawLength - height);
}

}  // namespace

double restingJaw(const Model& m, int hand, const State& s, double wanted) {
  const ToolState& t = s.tools[hand];
  const ToolParams& p = toolOf(m, s, hand);
  if (!m.params.thread.knots || t.holdsNeedle || wanted >= t.jaw || p.kind == ToolKind::kElectrocautery) return wanted;
  // A strand across the jaws gives by this much under their force: half its thickness less what is squeezed.
  const double squeezed = kClosing / (2.0 * p.jawRadius * m.params.thread.lateralModulus);   // [m]
  const double half = std::fmax(0.0, m.strand.radius - squeezed);                            // [m]
  double rest = wanted;                        // [1]
  const double reach = kDeep + openedTo(p, 0.0) + 2.0 * p.jawRadius;                         // [m] of the tips; beyond, and a segment, nothing matters
  for (int i = 0; i + 1 < m.strand.nodes; ++i) {
    const double far = reach + m.strand.rest[i];                                             // [m]
    if ((s.strand.position[i] - t.proxy.position).squaredNorm() > far * far) continue;
    for (int k = 0; k < kPerSegment; ++k) {
      const double share = static_cast<double>(k) / kPerSegment;                             // [1]
      const Vec3 at = t.proxy.inverseApply((1.0 - share) * s.strand.position[i] + share * s.strand.position[i + 1]);
      if (at.z() < 0.0 || at.z() > kDeep || std::fabs(at.y()) > p.jawRadius) continue;
      const double open = openedTo(p, at.z());                                               // [m]
      if (std::fabs(at.x()) > t.jaw * open + m.strand.radius || s.threadContacts.cut[i]) continue;
      rest = std::fmax(rest, std::fmin(t.jaw, half / open));
    }
  }
  return rest;
}

}  // namespace halsted
