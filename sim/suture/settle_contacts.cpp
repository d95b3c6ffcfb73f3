#include <cmath>

#include "sim/suture/holes.h"
#include "sim/suture/strand_contacts.h"
#include "sim/suture/strand_sample.h"
#include "sim/tools/tool_shape.h"

namespace halsted {
namespace {

constexpr double kMostForce = 2.0;             // [N] on one sample: a thread pinched harder sinks into the tissue instead
constexpr double kTipFriction = 2.0;           // [1] a sharp tip catches: the dimple under it turns to face it (design)

void addTissueForce(const Model& m, const StrandContact& c, const Vec3& onStrand, std::vector<Vec3>& nodal) {
  if (c.feature >= static_cast<int>(m.surface.triangles.size())) return;
  const auto& v = m.surface.triangles[c.feature];
  for (int k = 0; k < 3; ++k) nodal[v[k]] -= c.weight[k] * onStrand;
}

/// The tip presses hard enough along its own axis, pointing into the tissue: it goes through.
bool punctures(const Model& m, const StrandState& s, const StrandContact& c, const Vec3& normal) {
  constexpr double kSkimming = 0.25;           // [1] cosine: flatter than 75 degrees from the normal it only scratches
  if (c.sample + 1 != sampleCount(m.strand)) return false;
  const Vec3 axis = strandTangent(m.strand, s, tipCoordinate(m.strand));
  return -c.force.dot(axis) >= m.params.needle.punctureForce && -axis.dot(normal) > kSkimming;
}

}  // namespace

double contactFriction(const Model& m, const StrandContact& c) {
  if (c.feature >= static_cast<int>(m.surface.triangles.size())) return m.params.contact.threadToolFriction;
  return c.sample + 1 == sampleCount(m.strand) ? kTipFriction : m.params.contact.threadTissueFriction;
}

void settleContacts(const Model& m, State& state, StepOutput& out) {
  StrandState& s = state.strand;
  const int triangles = static_cast<int>(m.surface.triangles.size());
  for (int i = 0; i < s.contactCount; ++i) addTissueForce(m, s.contacts[i], -s.contacts[i].force, state.work.change);
  for (ToolState& tool : state.tools) tool.strandForce.setZero();
  int kept = 0, punctured = -1;
  for (int i = 0; i < state.work.freshCount; ++i) {
    StrandContact c = state.work.freshContacts[i];
    const Vec3 normal = c.force, solved = state.work.strand.links[state.work.freshLink[i]].force;
    c.normalForce = solved.dot(normal);
    if (c.normalForce <= 0.0) continue;
    const double share = c.normalForce > kMostForce ? kMostForce / c.normalForce : 1.0;
    const Vec3 tangent = solved - c.normalForce * normal;
    const double limit = contactFriction(m, c) * c.normalForce, size = tangent.norm();
    c.force = share * (c.normalForce * normal + (size > limit ? limit / size : 1.0) * tangent);
    c.normalForce *= share;
    if (c.feature < triangles && punctures(m, s, c, normal)) { punctured = i; continue; }
    addTissueForce(m, c, c.force, state.work.change);
    const int hand = c.feature < triangles ? -1 : solidHand(c.feature - triangles);
    if (hand >= 0) state.tools[hand].strandForce -= c.force;
    s.contacts[kept++] = c;
  }
  for (int i = kept; i < s.contactCount; ++i) s.contacts[i] = StrandContact{};
  s.contactCount = kept;
  if (punctured >= 0) {
    const StrandContact& c = state.work.freshContacts[punctured];
    openEntry(m, c.feature, c.weight, c.force, state, out);   // `force` still holds the normal
  }
}

void gatherContactForces(const Model& m, const StrandState& s, std::vector<Vec3>& nodal) {
  for (int i = 0; i < s.contactCount; ++i) addTissueForce(m, s.contacts[i], s.contacts[i].force, nodal);
}

}  // namespace halsted
