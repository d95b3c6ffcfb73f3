#include "sim/tools/local_contact.h"

#include <cmath>

#include "sim/suture/holes.h"
#include "sim/tools/find_touch.h"
#include "sim/tools/touch.h"

namespace halsted {
namespace {

constexpr double kTautStiffness = 400.0;       // [N/m] a taut thread along its pull: the tissue at its last hole gives
constexpr double kDamping = 0.4;               // [N s/m] while touching: b > K T / 2 for 0.8 N/mm at 1 kHz (Colgate and Schenkel 1997)

constexpr double kLeastGive = 1e-6;            // [m/N] of what is held in place

/// What one hole gives when all of them are pushed alike [m/N]. Asked at the end of the step, when holes have come, gone and moved up.
double holeGive(const Model& m, const StrandState& s, int hole) {
  double sum = 0.0;                            // [m/N]
  for (int k = 0; k < s.holeCount; ++k) sum += std::fabs(complianceBetween(m, placeOf(s.holes[hole]), placeOf(s.holes[k])));
  return std::fmax(sum, kLeastGive);
}

/// Stiffness of the needle's holes against a translation of the hand that holds the needle [N/m].
Mat3 needleStiffness(const Model& m, const State& s) {
  Mat3 k = Mat3::Zero();
  for (int i = 0; i < s.strand.holeCount; ++i) {
    const Hole& h = s.strand.holes[i];
    if (h.coordinate <= m.strand.length) continue;
    const Vec3 t = strandTangent(m.strand, s.strand, h.coordinate);
    const bool sticks = h.slip == 0 && h.role != static_cast<std::int32_t>(HoleRole::kTip);
    k += (sticks ? Mat3(Mat3::Identity()) : Mat3(Mat3::Identity() - t * t.transpose())) / holeGive(m, s.strand, i);
  }
  return k;
}

Mat3 inSeries(const Mat3& k, double coupling) {  // [N/m] both
  const Mat3 sum = k + coupling * Mat3::Identity();
  const Mat3 series = coupling * (k * sum.inverse());
  return 0.5 * (series + series.transpose());
}

constexpr double kAhead = 1.5e-3;              // [m] planes are published this far before the tissue,
constexpr double kAheadTime = 5e-3;            // [s] and as far as the hand moves in this time: the longest usual age of a model
constexpr double kFastest = 1.0;               // [m/s] no hand is faster

/// Planes where touching would begin, and the spring that waits behind the nearest: the tissue there in series with the coupling.
/// One spring for all directions, since each plane takes it along its own normal.
void writeAhead(const Model& m, const State& s, int hand, const ToolSample& sample, LocalContact& c) {
  const double speed = std::fmin(sample.velocity.norm(), kFastest);   // [m/s]; fmin: a speed that is no number is the fastest
  std::array<TouchPoint, LocalContact::kMaxPlanes> found;
  c.planeCount = findAhead(m, hand, s, kAhead + kAheadTime * speed, found);
  c.ahead = c.planeCount > 0;
  if (!c.ahead) return;
  c.stiffness = Mat3::Identity() / (touchCompliance(m, found[0]) + 1.0 / m.params.tools[hand].couplingStiffness);
  for (int i = 0; i < c.planeCount; ++i) c.planes[i] = {c.position + found[i].gap * found[i].normal, -found[i].normal};
}

/// The strongest contacts as planes in device space: where the normal force would vanish.
void writePlanes(const ToolState& t, LocalContact& c) {
  c.planeCount = 0;
  for (int i = 0; i < t.contactCount && c.planeCount < LocalContact::kMaxPlanes; ++i) {
    const Vec3 away = -t.contactNormal[i];
    bool known = false;
    for (int k = 0; k < c.planeCount; ++k) known = known || c.planes[k].normal.dot(away) > 0.95;
    if (known) continue;
    const double stiff = away.dot(c.stiffness * away), push = c.force.dot(away);
    c.planes[c.planeCount++] = {c.position + (stiff > 1.0 && push > 0.0 ? push / stiff : 0.0) * away, away};
  }
}

}  // namespace

void writeLocalContact(const Model& m, const State& s, int hand, const ToolSample& sample, LocalContact& c) {
  const ToolState& t = s.tools[hand];
  const double coupling = m.params.tools[hand].couplingStiffness;
  c.step = s.step;
  c.position = t.device.position;
  c.force = t.force;
  Mat3 k = touchStiffness(m, s, hand);
  if (t.holdsNeedle) k += needleStiffness(m, s);
  const double pull = t.threadForce.norm();
  if (pull > 0.02) {
    const Vec3 d = t.threadForce / pull;
    k += kTautStiffness * d * d.transpose();
  }
  c.stiffness = inSeries(k, coupling);
  c.touching = t.force.squaredNorm() > 1e-12;
  c.damping = c.touching ? Mat3(kDamping * Mat3::Identity()) : Mat3(Mat3::Zero());
  const bool bilateral = t.grasp.count > 0 || t.holdsNeedle || t.threadCoordinate >= 0.0;
  c.planeCount = 0;
  c.ahead = false;
  if (bilateral) return;
  if (c.touching) writePlanes(t, c);
  else writeAhead(m, s, hand, sample, c);
}

}  // namespace halsted
