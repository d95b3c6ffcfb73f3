#include "tests/app/energy_audit.h"

#include <algorithm>

#include "sim/suture/holes.h"
#include "sim/suture/strand_contacts.h"
#include "sim/suture/tied_stitches.h"
#include "sim/tissue/tissue.h"
#include "tests/sim/kinetic_energy.h"

namespace halsted::app {
namespace {

constexpr int kLook = 32;                      // steps between two looks at the elastic energy, which takes as long as ten

/// Of a force on the tissue at a point of it, by the motion of the tool's point that lies there.  [m] [N] [J]
double workAt(const Pose& before, const Pose& after, const Vec3& point, const Vec3& force) {
  const Vec3 local = after.orientation.conjugate() * (point - after.position);
  return force.dot(point - before.apply(local));
}

Vec3 pointAt(const Model& m, const State& s, int triangle, const std::array<double, 3>& weight) {   // [1]
  return pointOn(m.surface, s.tissue.position, triangle, weight);
}

double workOfTool(const Model& m, const State& s, const ToolState& t, const Pose& before) {   // [J]
  double sum = 0.0;                            // [J]
  for (int i = 0; i < t.contactCount; ++i) sum += workAt(before, t.proxy, pointAt(m, s, t.contactTriangle[i], t.contactWeight[i]), t.contactForce[i]);
  for (int i = 0; i < t.graspCount; ++i) sum += workAt(before, t.proxy, pointAt(m, s, t.graspTriangle[i], t.graspWeight[i]), t.graspForce[i]);
  return sum;
}

}  // namespace

void EnergyAudit::before(const State& s) {
  position_ = s.tissue.position;
  for (int hand = 0; hand < kHands; ++hand) tool_[hand] = s.tools[hand].proxy;
}

void EnergyAudit::after(const Model& m, const State& s) {
  force_.assign(position_.size(), Vec3::Zero());
  gatherHoleForces(m, s.strand, force_);
  gatherStitchForces(m, s, force_);
  gatherContactForces(m, s.strand, force_);
  for (std::size_t i = 0; i < position_.size(); ++i) work_ += (force_[i] + m.tissue.mass[i] * m.params.gravity).dot(s.tissue.position[i] - position_[i]);
  for (int hand = 0; hand < kHands; ++hand) work_ += workOfTool(m, s, s.tools[hand], tool_[hand]);
  if (++sinceLook_ < kLook) return;
  sinceLook_ = 0;
  const double energy = kineticEnergy(m, s) + elasticEnergy(m.tissue, s.tissue), balance = energy - work_;   // [J]
  most_ = std::max(most_, energy);
  least_ = std::min(least_, balance);
  created_ = std::max(created_, balance - least_);
}

}  // namespace halsted::app
