/// A step is a function of its arguments (DESIGN 7): bits depend on the input alone, not on the heap, nor on a save and load between.
#include <gtest/gtest.h>

#include <memory>

#include "tests/sim/hand_noise.h"
#include "tests/sim/tissue_block.h"

namespace halsted {
namespace {

constexpr int kSteps = 2000;

SimParams solverParams(TissueSolver solver) {
  SimParams p = wallParams();
  p.tissue.solver = solver;
  p.gravity = Vec3(0, 0, -9.81);
  p.needle.punctureForce = 0.3;                // random motion goes through the wall early
  return p;
}

const Pose kAtTheEdge{Vec3(3.5e-3, 12e-3, 15e-3), Quat::Identity()};   // the left jaws lean on the wall from the start

class StepDeterminism : public testing::TestWithParam<TissueSolver> {
 protected:
  SimParams params() const { return solverParams(GetParam()); }
  int steps() const { return GetParam() == TissueSolver::kProjective ? kSteps : 300; }
};
INSTANTIATE_TEST_SUITE_P(Solver, StepDeterminism,
                         testing::Values(TissueSolver::kProjective, TissueSolver::kXpbd, TissueSolver::kShapeMatching),
                         [](const auto& solver) { return solverName(solver.param); });

TEST_P(StepDeterminism, SameInputGivesTheSameBitsWhereverTheStateLies) {
  auto a = std::make_unique<StepRig>(params(), kNeedleBeside, kAtTheEdge);
  std::vector<std::unique_ptr<char[]>> ballast;                // shifts what is allocated after it
  for (int i = 1; i < 400; ++i) ballast.push_back(std::make_unique<char[]>(static_cast<std::size_t>(i * 37)));
  auto b = std::make_unique<StepRig>(params(), kNeedleBeside, kAtTheEdge);
  HandNoise left(5), right(5);
  for (int k = 0; k < steps(); ++k) {
    left.move(a->input);
    right.move(b->input);
    a->step();
    b->step();
    if (k % 50 == 0) ballast[static_cast<std::size_t>(k / 50)].reset();
    if (k == steps() / 2) {                      // the second state moves to new addresses
      State moved = b->state;
      b->state = std::move(moved);
    }
    ASSERT_EQ(hash(a->state), hash(b->state)) << "step " << k << ": " << diff(a->state, b->state);
  }
  EXPECT_GT(a->state.metrics.hands[kLeft].peakForce, 0.01) << "the motion touched nothing";
}

TEST_P(StepDeterminism, ARestoredRunContinuesIdentically) {
  StepRig a(params(), kNeedleBeside, kAtTheEdge), b(params(), kNeedleBeside, kAtTheEdge);
  HandNoise noise(11);
  for (int k = 0; k < steps(); ++k) {
    noise.move(a.input);
    a.step();
    if (k % 250 == 100) {                        // whatever b did before is overwritten by what was saved
      std::string error;
      ASSERT_TRUE(load(save(a.state), b.state, error)) << error;
    }
    b.input = a.input;
    if (k % 250 > 100) {
      --b.input.tools[kLeft].tick;
      --b.input.tools[kRight].tick;
      b.step();
      ASSERT_EQ(hash(a.state), hash(b.state)) << "step " << k << ": " << diff(a.state, b.state);
    }
  }
}

TEST(StepDeterminismInput, AChangedSampleChangesTheBits) {
  StepRig a(solverParams(TissueSolver::kProjective), kNeedleBeside, kAtTheEdge), b(solverParams(TissueSolver::kProjective), kNeedleBeside, kAtTheEdge);
  a.run(5);
  b.input.tools[kRight].pose.position.x() += 1e-12;
  b.run(5);
  EXPECT_NE(hash(a.state), hash(b.state));
}

}  // namespace
}  // namespace halsted
