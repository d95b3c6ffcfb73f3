#include "sim/step.h"

#include <algorithm>

#include "sim/contact/tissue_contact.h"
#include "sim/cutting/burn.h"
#include "sim/measure.h"
#include "sim/needling/needling_scene.h"
#include "sim/outcome.h"
#include "sim/suture/assist_knot.h"
#include "sim/suture/fresh_thread.h"
#include "sim/suture/holes.h"
#include "sim/suture/knot_watch.h"
#include "sim/suture/knotting.h"
#include "sim/suture/strand_contacts.h"
#include "sim/suture/tied_stitches.h"
#include "sim/tissue/tissue.h"
#include "sim/tools/come_free.h"
#include "sim/tools/grasp.h"
#include "sim/tools/instrument.h"
#include "sim/tools/load_driver.h"
#include "sim/tools/local_contact.h"
#include "sim/tools/perforation.h"
#include "sim/tools/standing_clamps.h"
#include "sim/tools/tool_shape.h"
#include "sim/tools/touch.h"

namespace halsted {
namespace {

constexpr double kMostPressure = 1e5;          // [Pa] ten times what tears a bowel
constexpr double kLittle = 1e-4;               // [N] a hundredth of a gram

void beginOutput(StepOutput& out) {
  out.eventCount = out.droppedEvents = 0;
  for (LocalContact& c : out.contact) c.puncture = false;
}

/// Everything that pulled on the tissue at the end of the last step still does.
void carryForces(const Model& m, double lumenPressure, State& s) {   // [Pa]
  std::fill(s.work.force.begin(), s.work.force.end(), Vec3::Zero());
  std::fill(s.work.change.begin(), s.work.change.end(), Vec3::Zero());
  gatherHoleForces(m, s.strand, s.work.force);
  gatherStitchForces(m, s, s.work.force);
  gatherContactForces(m, s.strand, s.work.force);
  gatherTouchForces(m, s, s.work.force);
  gatherTissueContact(m, s, s.work.force);
  gatherPressure(m, s, lumenPressure, s.work.force);
}

/// A sample that is not a number moves nothing: the tool stays where it was.
ToolSample safeSample(const ToolSample& sample, const ToolState& t) {
  const bool finite = sample.pose.position.allFinite() && sample.pose.orientation.coeffs().allFinite() && sample.jaw == sample.jaw &&
                      sample.pose.position.squaredNorm() < 1.0 && sample.pose.orientation.squaredNorm() > 0.25 && sample.pose.orientation.squaredNorm() < 4.0;
  ToolSample safe = sample;
  if (!finite) { safe.pose = t.device; safe.jaw = t.jaw; }
  safe.pose.orientation.normalize();
  return safe;
}

StepInput safeInput(const StepInput& input, const State& s) {
  StepInput safe = input;
  if (!(input.lumenPressure > 0.0 && input.lumenPressure < kMostPressure)) safe.lumenPressure = 0.0;
  for (int hand = 0; hand < kHands; ++hand) safe.tools[hand] = safeSample(input.tools[hand], s.tools[hand]);
  return safe;
}

void moveTools(const Model& m, const StepInput& input, State& s, StepOutput& out) {
  for (int hand = 0; hand < kHands; ++hand) moveTool(m, hand, input.tools[hand], s, out);
}

bool solveThread(const Model& m, const KnottingMotion& motion, State& s, StepOutput& out) {
  if (m.params.thread.knots) return solveKnottedStrand(m, motion, s, out);
  return solveStrand(m.strand, m.params.dt, m.params.gravity, s.strand, s.work.strand);
}

/// Contacts are looked for where inertia takes the thread. It weighs next to nothing and goes where its neighbours pull it: what it has met on that way is
/// known after the solve, which is then done once more. Not where thread is not knotted: the purse-string's hanging needle was caught there, and it was not
/// shown that this was chance.
bool solveAgainstTissue(const Model& m, const KnottingMotion& motion, State& s, StepOutput& out) {
  if (!m.params.thread.knots) return solveThread(m, motion, s, out);
  s.work.strandBefore = s.strand;
  s.work.threadBefore = s.threadContacts;
  const int events = out.eventCount, dropped = out.droppedEvents;
  if (!solveThread(m, motion, s, out)) return false;
  if (!linkMetTissue(m, s)) return true;
  s.strand = s.work.strandBefore;
  s.threadContacts = s.work.threadBefore;
  out.eventCount = events;
  out.droppedEvents = dropped;
  return solveThread(m, motion, s, out);
}

void stepStrand(const Model& m, KnottingMotion motion, State& s, StepOutput& out) {
  if (threadOnTable(m, s)) return;
  s.work.strand.linkCount = s.work.strand.turnCount = 0;
  linkHoles(m, s);
  motion.solids.now = worldSolids(m, s);
  linkContacts(m, motion.solids, s);
  for (int hand = 0; hand < kHands; ++hand) motion.grasps[hand] = linkGrasp(m, hand, s);
  linkAssistKnot(m, s);
  const std::array<Vec3, kHands> tools{s.tools[0].proxy.position, s.tools[1].proxy.position};   // [m]
  if (!solveAgainstTissue(m, motion, s, out)) return;
  settleHoles(m, s, out);
  settleAssistKnot(m, s, out);
  settleContacts(m, s, out);
  settleToolForces(s);
  for (int hand = 0; hand < kHands; ++hand) {
    settleGrasp(m, hand, motion.grasps[hand], s, out);
    followSlowly(m, hand, tools[hand], s);
  }
}

/// Moves the tissue by its answer to the changes of force gathered so far. All together little, as from thread that lies still, they wait for the next
/// step, which begins with all forces that are kept (carryForces): answering costs as much as a step of tissue that nothing touches. What tissue pushes
/// on tissue for this step only (solvePairs) is then left out, and found missing again in the next.
void answerChange(const Model& m, State& s) {
  double squared = 0.0;                        // [N^2]
  for (const Vec3& f : s.work.change) squared += f.squaredNorm();
  if (squared > kLittle * kLittle) applyForceChange(m.tissue, s.work.change, s.tissue, s.work.tissue);
  std::fill(s.work.change.begin(), s.work.change.end(), Vec3::Zero());
}

void stepProcedure(const Model& m, State& s, StepOutput& out) {
  const int before = s.procedure.current;
  const ProcedureEvent event = advance(m.procedure, out.seen, s.step * m.params.dt, m.params.dt, s.procedure);
  if (event == ProcedureEvent::kNone) return;
  EventKind kind = EventKind::kProcedureCompleted;
  if (event == ProcedureEvent::kFault) kind = EventKind::kFault;
  if (event == ProcedureEvent::kLate) kind = EventKind::kStepLate;
  if (event == ProcedureEvent::kStepDone) kind = EventKind::kStepDone;
  if (event == ProcedureEvent::kBegunAnew) kind = EventKind::kBegunAnew;
  pushEvent(out, {s.step, kind, -1, before, s.step * m.params.dt});
}

void stepSuture(const Model& m, const StepInput& input, State& s, StepOutput& out) {
  if (input.command.kind == Command::Kind::kFreshThread) handFreshThread(m, s, out);
  if (input.command.kind == Command::Kind::kChangeInstrument) changeInstrument(m, input.command.value > 0.5 ? kRight : kLeft, s, out);
  if (input.command.kind == Command::Kind::kHandOver) handOverClamp(m, input.command.value > 0.5 ? kRight : kLeft, s, out);
  cutTissue(m, s, out);
  carryForces(m, input.lumenPressure, s);
  predictTissue(m.tissue, s.work.force, s.tissue, s.work.tissue);
  const std::array<Pose, kHands> before{s.tools[0].proxy, s.tools[1].proxy};
  const auto solidsBefore = worldSolids(m, s);
  moveTools(m, input, s, out);
  solveTouch(m, before, s);
  answerChange(m, s);                          // the strand meets the tissue where the tools have put it
  for (int hand = 0; hand < kHands; ++hand) {
    updateProxy(m, hand, s);
    slipGrasp(m, hand, s, out);
    settlePerforation(m, hand, s, out);
  }
  settleStandingClamps(m, s, out);
  settleStitches(m, s, out);
  stepStrand(m, {{solidsBefore, {}}, before, {}}, s, out);
  solveTissueContact(m, s);
  answerChange(m, s);
  finishTissue(m.tissue, s.tissue, s.work.tissue);
  for (int hand = 0; hand < kHands; ++hand) writeLocalContact(m, s, hand, input.tools[hand], out.contact[hand]);
}

}  // namespace

void step(const Model& m, const StepInput& given, State& s, StepOutput& out) {
  const StepInput input = safeInput(given, s);
  beginOutput(out);
  switch (m.params.model) {
    case ModelKind::kSuture: stepSuture(m, input, s, out); break;
    case ModelKind::kNeedling: stepNeedling(m, input, s, out); break;
  }
  ++s.step;
  watchKnots(m, s, out);
  measure(m, input, s, out);
  stepProcedure(m, s, out);
  for (LocalContact& c : out.contact) c.step = s.step;
}

}  // namespace halsted
