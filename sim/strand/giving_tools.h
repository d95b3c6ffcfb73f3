#pragma once
/// Tools that give way to thread. A hand is a spring of 1000 N/m, drawn thread forty times as stiff: answering each other a step late they
/// would throw each other to and fro. So each hand adds three unknowns to the strand's system, how far thread has pushed its solids in this
/// step, and where thread lies against these they are solved with it (coupled_solve.h). A hand has no mass here. Physics thread; no heap.
#include <array>
#include <vector>

#include "sim/strand/coupled_solve.h"
#include "sim/strand/thread_curve.h"
#include "sim/types.h"

namespace halsted {

struct GivingTool {
  double spring = 0.0;                         // [N/m] of the hand; 0: it stands. Set by the caller
  Vec3 offset = Vec3::Zero();                  // [m] that thread has pushed it, where the solids of this step are
  Vec3 shift = Vec3::Zero();                   // [m] farther in this step, at the iterate
  Vec3 correction = Vec3::Zero();              // [m] by which the last solve would move it on
};

struct GivingTools {
  std::array<GivingTool, kHands> tool;
  std::array<bool, kHands> touched{};          // does thread lie against it in this iterate?
  double moved = 0.0;                          // [m] by the last correction, of a hand that thread lies against
};

/// Before the first iteration of a step: no hand has moved yet.
void beginHands(GivingTools&);

/// Every iteration, the hands alone: each one's spring, and its force behind the strand's own in `rhs`.
void assembleHands(GivingTools&, std::vector<double>& rhs, CoupledSolve&);   // [N]
/// Thread at `sample` is pushed by a hand's solid with `force` and `stiffness`.
void addToHand(int hand, const CurveWeights& sample, const Vec3& force, const Mat3& stiffness, GivingTools&, std::vector<double>& rhs, CoupledSolve&);   // [N], [N/m]
/// After the solve: reads how far it moves the hands, and works that out, in `x`, of those that were not solved for.
void readHands(std::vector<double>& x, const CoupledSolve&, GivingTools&);   // [N] then [m]

/// The hands take a share of their last correction.
void shiftHands(double share, GivingTools&);   // [1]

/// The step is over: where the hands now are is where the next begins.
void settleHands(GivingTools&);

}  // namespace halsted
