#include "tests/app/energy_audit.h"

#include <algorithm>
#include <span>

#include "sim/contact/geometry.h"
#include "sim/suture/holes.h"
#include "sim/suture/strand_contacts.h"
#include "sim/suture/tied_stitches.h"
#include "sim/tissue/tissue.h"
#include "sim/tools/instrument.h"
#include "sim/tools/tool_shape.h"
#include "tests/sim/kinetic_energy.h"

namespace halsted::app {
namespace {

constexpr int kLook = 32;                      // steps between two looks at the elastic energy, which takes as long as ten

/// A tool has no mass: when what held it lets go it springs to where the hand is in one step, past all it touched, and forces at the end of
/// that way do not tell the work done on it.
constexpr double kFollowed = 1e-3;             // [m] in a step, as far as contacts are looked for

/// Of a force on the tissue at a point of it, by the motion of the tool's point that lies there; by the tissue's own where the tool sprang.
struct Work {
  const Model& m;
  const State& s;
  std::span<const Vec3> position;              // [m] of the tissue before the step
  Pose before, after;                          // of the tool
  std::array<CapsuleShape, kSolidsPerTool> wasOpen{}, isOpen{};        // its solids in its own frame, before and after

  /// How far jaws that open or close have moved the part of the tool that touches this point.  [m] in the tool's frame
  Vec3 ofJaws(const Vec3& local, const Vec3& normal) const {           // [m] [1] out of the tool, both in its frame
    Vec3 moved = Vec3::Zero();
    double nearest = 1e300;                    // [m^2] from the surface of a solid, in the direction in which it pushes
    for (int k = 0; k < kSolidsPerTool; ++k) {
      const CapsuleShape &was = wasOpen[k], &is = isOpen[k];
      const double along = closestOnSegment(local, is.a, is.b);        // [1]
      const Vec3 axis = is.a + along * (is.b - is.a);
      const double off = (axis + is.radius * normal - local).squaredNorm();
      if (off >= nearest) continue;
      nearest = off;
      moved = axis - (was.a + along * (was.b - was.a));
    }
    return moved;
  }
  double of(int triangle, const std::array<double, 3>& weight, const Vec3& force, const Vec3& normal = Vec3::Zero()) const {   // [1] [N] [1] [J]
    const Vec3 point = pointOn(m.surface, s.tissue.position, triangle, weight);
    const bool sprang = (after.position - before.position).squaredNorm() > kFollowed * kFollowed;
    if (sprang) return force.dot(point - pointOn(m.surface, position, triangle, weight));
    const Vec3 local = after.inverseApply(point), jaws = normal.isZero(0.0) ? normal : ofJaws(local, after.orientation.conjugate() * normal);
    return force.dot(point - before.apply(local - jaws));
  }
};

double workOfGrasp(const Work& work, const TissueGrasp& grasp) {   // [J]
  double sum = 0.0;                            // [J]
  for (int i = 0; i < grasp.count; ++i) sum += work.of(grasp.triangle[i], grasp.weight[i], grasp.force[i]);
  return sum;
}

double workOfTool(const Work& work, const ToolState& t) {   // [J]
  double sum = workOfGrasp(work, t.grasp);     // [J]
  for (int i = 0; i < t.contactCount; ++i) sum += work.of(t.contactTriangle[i], t.contactWeight[i], t.contactForce[i], t.contactNormal[i]);
  return sum;
}

}  // namespace

void EnergyAudit::before(const State& s) {
  position_ = s.tissue.position;
  for (int hand = 0; hand < kHands; ++hand) {
    tool_[hand] = s.tools[hand].proxy;
    jaw_[hand] = s.tools[hand].jaw;
  }
  for (int k = 0; s.clamps && k < kMostClamps; ++k) clamp_[k] = s.clamps->clamp[k].pose;
}

void EnergyAudit::after(const Model& m, const State& s) {
  force_.assign(position_.size(), Vec3::Zero());
  gatherHoleForces(m, s.strand, force_);
  gatherStitchForces(m, s, force_);
  gatherContactForces(m, s.strand, force_);
  for (std::size_t i = 0; i < position_.size(); ++i) work_ += (force_[i] + m.tissue.mass[i] * m.params.gravity).dot(s.tissue.position[i] - position_[i]);
  for (int hand = 0; hand < kHands; ++hand) {
    const ToolState& t = s.tools[hand];
    const ToolParams& tool = toolOf(m, s, hand);
    work_ += workOfTool({m, s, position_, tool_[hand], t.proxy, toolCapsules(tool, jaw_[hand]), toolCapsules(tool, t.jaw)}, t);
  }
  for (int k = 0; s.clamps && k < s.clamps->count; ++k)
    work_ += workOfGrasp({m, s, position_, clamp_[k], s.clamps->clamp[k].pose}, s.clamps->clamp[k].grasp);
  if (++sinceLook_ < kLook) return;
  sinceLook_ = 0;
  const double energy = kineticEnergy(m, s) + elasticEnergy(m.tissue, s.tissue), balance = energy - work_;   // [J]
  most_ = std::max(most_, energy);
  least_ = std::min(least_, balance);
  created_ = std::max(created_, balance - least_);
}

}  // namespace halsted::app
