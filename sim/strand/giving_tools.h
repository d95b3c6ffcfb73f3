#pragma once
/// Tools that give way to thread. A hand is a spring of 1000 N/m, drawn thread forty times as stiff: answering each other a step late they
/// would throw each other to and fro. So each hand adds three unknowns to the strand's system, how far thread has pushed its solids in this
/// step, as a border of the matrix (Schur complement, exact). A hand has no mass here. Physics thread; no heap.
#include <array>
#include <span>
#include <vector>

#include "sim/lanes.h"
#include "sim/strand/thread_curve.h"
#include "sim/types.h"

namespace halsted {

struct GivingTool {
  double spring = 0.0;                         // [N/m] of the hand; 0: it stands. Set by the caller
  Vec3 offset = Vec3::Zero();                  // [m] that thread has pushed it, where the solids of this step are
  Vec3 shift = Vec3::Zero();                   // [m] farther in this step, at the iterate
  Vec3 correction = Vec3::Zero();              // [m] by which the last solve would move it on
};

struct ToolBorder {
  std::array<GivingTool, kHands> tool;
  std::array<Mat3, kHands> stiffness;          // [N/m] of each hand's own unknowns at the iterate
  std::array<Vec3, kHands> force;              // [N] on each hand at the iterate
  double moved = 0.0;                          // [m] by the last correction, of a hand that thread lies against
  std::array<bool, kHands> touched{};          // does thread lie against it in this iterate?
  std::array<std::vector<Lanes4>, kHands> column, solved;   // [N/m] coupling with the strand, three lanes used; the matrix's inverse times it [1]
  std::array<Lanes4*, kHands> toSolve{};       // the first of `solved` are those of hands touched
};

void resizeBorder(int unknowns, ToolBorder&);

/// Before the first iteration of a step: no hand has moved yet.
void beginBorder(ToolBorder&);
/// Every iteration: the hands alone, then what thread adds.
void clearBorder(ToolBorder&);
/// Thread at `sample` is pushed by a hand's solid with `force` and `stiffness`.
void addToBorder(int hand, const CurveWeights& sample, const Vec3& force, const Mat3& stiffness, ToolBorder&);   // [N], [N/m]

/// The columns of the hands that thread lies against, which the inverse of the strand's matrix is then to be applied to, in place:
/// three right-hand sides each, BandedMatrix::kHalf rows of zeros behind.
std::span<Lanes4* const> copyColumns(ToolBorder&);
/// Once that is done: corrects x for the hands' motion, and writes that.
void moveHands(ToolBorder&, std::vector<double>& x);   // [m]

/// The hands take a share of their last correction.
void shiftHands(double share, ToolBorder&);    // [1]

/// The step is over: where the hands now are is where the next begins.
void settleBorder(ToolBorder&);

}  // namespace halsted
