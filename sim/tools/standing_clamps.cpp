#include "sim/tools/standing_clamps.h"

#include "sim/cutting/pieces.h"
#include "sim/suture/holes.h"
#include "sim/tools/find_touch.h"
#include "sim/tools/grasp.h"
#include "sim/tools/instrument.h"

namespace halsted {
namespace {

ClampRefusal refusal(const Model& m, const State& s, int hand) {
  if (toolOf(m, s, hand).kind != ToolKind::kAllis) return ClampRefusal::kNoClamp;
  if (s.tools[hand].grasp.count == 0) return ClampRefusal::kHoldsNothing;
  if (s.clamps->left == 0 || s.clamps->count == kMostClamps) return ClampRefusal::kNoneLeft;
  return ClampRefusal::kNone;
}

/// Those behind it move up; what it holds is let go of.
void takeOff(const Model& m, int which, double held, State& s, StepOutput& out) {   // held [N]
  StandingClamps& all = *s.clamps;
  letGoOfTissue(m, all.clamp[which].grasp, s);
  for (int k = which; k + 1 < all.count; ++k) all.clamp[k] = all.clamp[k + 1];
  all.clamp[--all.count] = StandingClamp{};
  pushEvent(out, {s.step, EventKind::kClampReleased, -1, which, held});
}

/// Does it hold a free piece that a hand holds, too?
bool mayLetGo(const Model& m, const State& s, const StandingClamp& c) {
  if (!s.cut || s.cut->pieces == 0) return false;
  const int piece = s.cut->piece[m.surface.triangleTet[c.grasp.triangle[0]]];
  return piece > 0 && heldByHand(m, s, piece);
}

}  // namespace

void handOverClamp(const Model& m, int hand, State& s, StepOutput& out) {
  if (!s.clamps || hand < 0 || hand >= kHands) return;
  const ClampRefusal why = refusal(m, s, hand);
  s.clamps->refusal = static_cast<std::int32_t>(why);
  if (why != ClampRefusal::kNone) {
    pushEvent(out, {s.step, EventKind::kClampRefused, hand, s.clamps->refusal, 0.0});
    return;
  }
  ToolState& t = s.tools[hand];
  StandingClamp& c = s.clamps->clamp[s.clamps->count++];
  c = {hand, s.instruments ? s.instruments->second[hand] : 0, t.jaw, t.device, t.proxy, t.grasp};
  c.held.position = t.proxy.position - graspForce(c.grasp) / couplingOf(m, s, hand);   // where the tissue draws it from: it stays where it is
  while (t.grasp.count > 0) dropGraspPoint(t.grasp, t.grasp.count - 1);
  --s.clamps->left;
  for (int other = 0; other < kHands; ++other) listNearTriangles(m, other, s);
  out.contact[hand].puncture = true;           // the hand feels it go at once
  pushEvent(out, {s.step, EventKind::kClampHandedOver, hand, s.clamps->left, 0.0});
}

bool inStandingClamp(const Model& m, const State& s, int triangle) {
  for (int k = 0; s.clamps && k < s.clamps->count; ++k)
    if (isHeld(m, s.clamps->clamp[k].grasp, triangle)) return true;
  return false;
}

TissueGrasp& graspOf(State& s, int holder) { return holder < kHands ? s.tools[holder].grasp : s.clamps->clamp[holder - kHands].grasp; }

double couplingOf(const Model& m, const State& s, int holder) {
  return m.params.tools[holder < kHands ? holder : s.clamps->clamp[holder - kHands].hand].couplingStiffness;
}

void findStandingGrasps(const Model& m, State& s) {
  for (int k = 0; s.clamps && k < s.clamps->count; ++k) {
    const StandingClamp& c = s.clamps->clamp[k];
    appendGrasp(m, kHands + k, c.pose, clampOf(m, c).gripForce, c.grasp, s);
  }
}

void settleStandingClamps(const Model& m, State& s, StepOutput& out) {
  for (int k = s.clamps ? s.clamps->count - 1 : -1; k >= 0; --k) {
    StandingClamp& c = s.clamps->clamp[k];
    const Vec3 pull = graspForce(c.grasp);     // [N]
    c.pose.position = c.held.position + pull / couplingOf(m, s, kHands + k);
    slideThroughJaws(m, clampOf(m, c), c.pose, c.grasp, s);
    if (c.grasp.count == 0 || mayLetGo(m, s, c)) takeOff(m, k, pull.norm(), s, out);
  }
}

void dropStandingGrasps(const Model& m, State& s, StepOutput& out) {
  for (int k = s.clamps ? s.clamps->count - 1 : -1; k >= 0; --k) {
    TissueGrasp& grasp = s.clamps->clamp[k].grasp;
    const double held = graspForce(grasp).norm();                // [N]
    for (int g = grasp.count - 1; g >= 0; --g)
      if (!exposed(m.surface, s.tissue.gone, grasp.triangle[g])) dropGraspPoint(grasp, g);
    if (grasp.count == 0) takeOff(m, k, held, s, out);
  }
}

}  // namespace halsted
