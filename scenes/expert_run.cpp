#include <algorithm>
#include <cmath>

#include "scenes/expert_state.h"
#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

constexpr double kTurn = 4.0;                  // [rad/s] wrist
constexpr double kApproach = 0.02;             // [m] above what is to be picked up

bool runAction(const Scene& scene, std::string& failure) {
  if (scene.action.kind == "bite") return runBite(scene, failure);
  if (scene.action.kind == "draw") return runDraw(scene, failure);
  if (scene.action.kind == "cut") return runCut(scene, failure);
  if (scene.action.kind == "traction") return runTraction(scene, failure);
  if (scene.action.kind == "take_tails" || scene.action.kind == "take_stay") return runTakeTails(scene, failure);
  if (scene.action.kind == "tighten") return scene.state.metrics.seam ? runCrossed(scene, failure) : runTighten(scene, failure);
  if (scene.action.kind == "tie") return scene.state.assist ? runCrossed(scene, failure) : runTie(scene, failure);
  if (scene.action.kind == "let_go") return runLetGo(scene);
  if (scene.action.kind == "take_out") return runTakeOut(scene);
  if (scene.action.kind == "fresh_thread") return runFreshThread(scene, failure);
  if (scene.action.kind == "change_tools") return runChangeTools(scene, failure);
  if (scene.action.kind == "hold_fold") return runHoldFold(scene, failure);
  if (scene.action.kind == "hand_over") return runHandOver(scene, failure);
  if (scene.action.kind == "cut_ring") return runCutRing(scene, failure);
  if (scene.action.kind == "take_away") return runTakeAway(scene, failure);
  if (scene.action.kind == "hold") return scene.inPhase >= scene.action.seconds;
  return runNeedling(scene, failure);
}

/// Does each hand hold a tail, one on either side of the stitch?
bool holdBothTails(const State& s) {
  if (s.strand.holeCount == 0) return false;
  const auto [least, most] = std::minmax(s.tools[kLeft].threadCoordinate, s.tools[kRight].threadCoordinate);   // [m]
  return least >= 0.0 && least < s.strand.holes[0].coordinate && most > s.strand.holes[s.strand.holeCount - 1].coordinate;
}

/// Goes past what is not done at this level of assistance, or with what the hands hold; it takes no time.
void skipWhatIsNotDone(const ExpertScript& script, const Model& model, const State& state, ExpertState& e) {
  const auto skipped = [&](const ExpertAction& a) {
    if (a.assist && *a.assist != model.params.thread.assist) return true;
    return a.unlessHeld && e.phase == 0 && holdBothTails(state);
  };
  while (e.action < script.actions.size() && skipped(script.actions[e.action])) ++e.action;
}

void begin(const State& state, ExpertState& e) {
  for (int h = 0; h < kHands; ++h) {
    e.hand[h].command = state.tools[h].device;
    e.hand[h].jaw = state.tools[h].jaw;
  }
  e.started = true;
  e.actionStart = e.phaseStart = state.step;
}

bool sameStitch(const ExpertAction& a, const ExpertAction& b) { return a.stitch >= 0 && a.stitch == b.stitch; }

/// Is the procedure completed? One without steps never is.
bool completed(const Scene& s) {
  const std::size_t steps = s.model.procedure.size();
  return steps > 0 && static_cast<std::size_t>(s.state.procedure.current) == steps;
}

/// Does the next stitch begin with this action, which follows `last`? With the asking for its thread.
bool beginsStitch(const ExpertAction& action, const ExpertAction& last) {
  return last.stitch >= 0 && (!sameStitch(action, last) || action.kind == "fresh_thread");
}

/// What follows an action that is done: not another attempt at its stitch, and no further stitch once the procedure is completed.
std::size_t after(const ExpertScript& script, const Scene& s) {
  const ExpertAction& last = script.actions[s.memory.action];
  std::size_t next = s.memory.action + 1;
  while (next < script.actions.size() && sameStitch(script.actions[next], last) && script.actions[next].attempt != last.attempt) ++next;
  const bool enough = next < script.actions.size() && beginsStitch(script.actions[next], last) && completed(s);
  return enough ? script.actions.size() : next;
}

/// What follows one that cannot be done: the next attempt at its stitch, or nothing.
std::size_t insteadOf(const ExpertScript& script, std::size_t lost) {
  const ExpertAction& last = script.actions[lost];
  for (std::size_t next = lost + 1; next < script.actions.size() && sameStitch(script.actions[next], last); ++next)
    if (script.actions[next].attempt != last.attempt) return next;
  return script.actions.size();
}

void goOn(const State& state, std::size_t action, ExpertState& e) {
  e.action = action;
  e.planned = false;
  e.attempt = 0;
  e.phase = 0;
  e.actionStart = e.phaseStart = state.step;
}

/// "file:line: " of an action, and with "action." of the key that follows.
std::string lineOf(const ExpertScript& script, const ExpertAction& a) { return quoted(script.origin) + ":" + std::to_string(a.line) + ": "; }
std::string placeOf(const ExpertScript& script, const ExpertAction& a) { return lineOf(script, a) + "action."; }

/// Is this an action of the scene's kind, on a point that it has?
void checkTechnique(const ExpertAction& a, const std::string& where, const Model& model) {
  if (a.kind != "hold" && isSutureAction(a.kind) == model.body.has_value())
    throw InputError(where + "do: '" + a.kind + "' is not done in a scene of this kind");
  if ((a.kind == "hold_fold" || a.kind == "hand_over" || a.kind == "cut_ring" || a.kind == "take_away") && model.mesh.cuttable.empty())
    throw InputError(where + "do: '" + a.kind + "': nothing can be cut in this scene");
  if (a.point.empty()) return;
  for (const Acupoint& point : model.body->points)
    if (point.id == a.point) return;
  throw InputError(where + "point: this body has no point '" + a.point + "'");
}

}  // namespace

void ExpertStateDeleter::operator()(ExpertState* e) const { delete e; }

ExpertStatePtr beginExpert(const ExpertScript& script, const Model& model) {
  for (const ExpertAction& a : script.actions) {
    checkTechnique(a, placeOf(script, a), model);
    BitePlan plan;
    if (a.kind == "bite" && !planPlaces(model, a, plan)) {
      throw InputError(placeOf(script, a) + "do: impossible bite: the wall has no place at that angle and depth, "
                       "or the needle is too small for that width");
    }
  }
  return ExpertStatePtr(new ExpertState);
}

Pose parked(int hand) { return {Vec3(hand == kLeft ? -0.06 : 0.06, 0.02, 0.055), Quat::Identity()}; }

std::array<Pose, kHands> startPoses(const Model& m) {
  if (m.body) return needlingStart(*m.body);
  return {parked(kLeft), parked(kRight)};
}

Command takeSpokenCommand(ExpertState& e) {
  const Command spoken = e.spoken;
  e.spoken = {};
  return spoken;
}

void goTo(const Scene& s, int phase) {
  s.memory.phase = phase;
  s.memory.phaseStart = s.state.step;
}

void nextPhase(const Scene& s) { goTo(s, s.memory.phase + 1); }

Pose above(const Pose& tool, double distance) { return {tool.position + distance * (tool.orientation * Vec3::UnitZ()), tool.orientation}; }

bool moveHand(const Scene& s, int hand, const Pose& goal, double speed) {
  return travel(s.memory.hand[hand], goal, speed, kTurn, s.dt);
}

bool pickUp(const Scene& s, int hand, const Pose& grip, int first) {
  HandMotion& h = s.memory.hand[hand];
  const int phase = s.memory.phase - first;
  constexpr double kSettle = 0.25, kClose = 0.3;                 // [s] the eye settles over the place; the jaws close
  constexpr double kPatience = 2.5;                              // [s] what swings to and fro is not waited for
  if (phase == 0) {
    h.jaw = 1.0;
    const bool over = moveHand(s, hand, above(grip, kApproach), 0.10) && s.inPhase > kSettle;
    if (over || s.inPhase > kPatience) nextPhase(s);
  } else if (phase == 1) {
    const Pose& seen = s.state.tools[hand].proxy;
    const bool near = moveHand(s, hand, grip, 0.04) && (seen.position - grip.position).norm() < 0.7e-3;
    if (near || s.inPhase > 1.5) nextPhase(s);
  } else {
    h.jaw = 0.0;
    return s.inPhase > kClose;
  }
  return false;
}

bool advanceExpert(const ExpertScript& script, const Model& model, const State& state, ExpertState& e,
                   std::array<HandTarget, kHands>& targets, std::string& failure) {
  if (!e.started) begin(state, e);
  skipWhatIsNotDone(script, model, state, e);
  if (e.action < script.actions.size()) {
    const ExpertAction& action = script.actions[e.action];
    const double dt = model.params.dt;
    const Scene scene{model, state, e, action, dt, static_cast<double>(state.step - e.phaseStart) * dt};
    std::string why;
    const bool finished = runAction(scene, why);
    const bool late = static_cast<double>(state.step - e.actionStart) * dt > action.seconds && action.kind != "hold";
    if (!why.empty() || (late && !finished)) {
      failure = lineOf(script, action) + action.kind + ": " + (why.empty() ? "ran out of time in phase " + std::to_string(e.phase) : why);
      goOn(state, insteadOf(script, e.action), e);
    } else if (finished) {
      goOn(state, after(script, scene), e);
    }
  }
  for (int h = 0; h < kHands; ++h) targets[h] = look(e.hand[h], state.tools[h].proxy, model.params.dt);
  return e.action < script.actions.size();
}

}  // namespace halsted::scenes
