#include "sim/cutting/loose_ends.h"

#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"
#include "sim/suture/holes.h"
#include "sim/suture/tied_stitches.h"
#include "sim/tools/find_touch.h"
#include "sim/tools/grasp.h"
#include "sim/tools/standing_clamps.h"
#include "sim/tools/touch.h"

namespace halsted {
namespace {

bool bare(const Model& m, const State& s, int triangle) { return exposed(m.surface, s.tissue.gone, triangle); }

/// Tissue against itself and against the rod.
void dropPairs(const Model& m, State& s) {
  TissueState& t = s.tissue;
  int kept = 0;
  for (int i = 0; i < t.pairCount; ++i) {
    if (!s.cut->bare[t.pairVertex[i]] || !bare(m, s, t.pairTriangle[i])) continue;
    t.pairVertex[kept] = t.pairVertex[i];
    t.pairTriangle[kept] = t.pairTriangle[i];
    t.pairForce[kept++] = t.pairForce[i];
  }
  for (int i = kept; i < t.pairCount; ++i) { t.pairVertex[i] = t.pairTriangle[i] = -1; t.pairForce[i] = 0.0; }
  t.pairCount = kept;
  for (std::size_t v = 0; v < t.rodForce.size(); ++v)
    if (!s.cut->bare[v]) t.rodForce[v].setZero();
}

void dropStrandContacts(const Model& m, State& s) {
  StrandState& strand = s.strand;
  const int triangles = static_cast<int>(m.surface.triangles.size());
  int kept = 0;
  for (int i = 0; i < strand.contactCount; ++i) {
    if (strand.contacts[i].feature < triangles && !bare(m, s, strand.contacts[i].feature)) continue;
    strand.contacts[kept++] = strand.contacts[i];
  }
  for (int i = kept; i < strand.contactCount; ++i) strand.contacts[i] = StrandContact{};
  strand.contactCount = kept;
}

void dropToolContacts(const Model& m, ToolState& t, const State& s) {
  int kept = 0;
  for (int i = 0; i < t.contactCount; ++i) {
    if (!bare(m, s, t.contactTriangle[i])) continue;
    t.contactTriangle[kept] = t.contactTriangle[i];
    t.contactWeight[kept] = t.contactWeight[i];
    t.contactNormal[kept] = t.contactNormal[i];
    t.contactForce[kept++] = t.contactForce[i];
  }
  for (int i = kept; i < t.contactCount; ++i) {
    t.contactTriangle[i] = -1;
    t.contactWeight[i] = {};
    t.contactNormal[i] = t.contactForce[i] = Vec3::Zero();
  }
  t.contactCount = kept;
}

void dropGrasps(const Model& m, int hand, State& s, StepOutput& out) {
  ToolState& t = s.tools[hand];
  const int before = t.grasp.count;
  const double held = touchForce(t).norm();    // [N]
  for (int g = t.grasp.count - 1; g >= 0; --g)
    if (!bare(m, s, t.grasp.triangle[g])) dropGraspPoint(t.grasp, g);
  if (before > 0 && t.grasp.count == 0) pushEvent(out, {s.step, EventKind::kTissueReleased, hand, -1, held});
}

}  // namespace

void letGoOfGone(const Model& m, State& s, StepOutput& out) {
  dropPairs(m, s);
  dropStrandContacts(m, s);
  tearHolesInGone(m, s, out);
  tearStitchesInGone(m, s, out);
  dropStandingGrasps(m, s, out);
  for (int hand = 0; hand < kHands; ++hand) {
    dropToolContacts(m, s.tools[hand], s);
    dropGrasps(m, hand, s, out);
    listNearTriangles(m, hand, s);             // what has been laid bare is there from now on
    out.contact[hand].puncture = true;         // the force may jump
  }
}

}  // namespace halsted
