/// A knot is looked at every 0.1 s. Thread that is drawn past itself may be read wrong for a look or two: that is no fault. A granny is one,
/// before the step that ties the knot is done.
#include <gtest/gtest.h>

#include "scenes/scene.h"
#include "tests/sim/rehearsal.h"
#include "tests/support/source_folder.h"

namespace halsted {
namespace {

/// The step of a scene in which the knot is tied, alone.
struct Tie : Rehearsal {
  int faults = 0, faultsBeforeDone = -1;

  explicit Tie(const std::string& scene) {
    for (const ProcedureStep& tied : scenes::readScene(testing::sourceFolder() + "/scenes/" + scene, {}).procedure)
      if (tied.hasFault && tied.fault.quantity == Quantity::kWrongThrows) table.push_back(tied);
  }
  void look(bool granny, bool locked) {        // until the next look
    (*this)[Quantity::kWrongThrows] = granny;
    (*this)[Quantity::kKnotLocks] = locked;
    for (int k = 0; k < 100; ++k) {
      const ProcedureEvent event = once();
      faults += event == ProcedureEvent::kFault;
      if (event == ProcedureEvent::kCompleted && faultsBeforeDone < 0) faultsBeforeDone = faults;
    }
  }
};

class GrannyFault : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Scene, GrannyFault, ::testing::Values("connell", "stay", "lembert", "altemeier"), [](const auto& p) { return std::string(p.param); });

TEST_P(GrannyFault, IsNotWhatIsReadForALookOrTwo) {
  Tie tie(GetParam());
  ASSERT_EQ(tie.table.size(), 1u);
  for (int again = 0; again < 3; ++again) {
    tie.look(true, false);
    tie.look(true, false);
    tie.look(false, false);
  }
  EXPECT_EQ(tie.faults, 0);
}

TEST_P(GrannyFault, IsAKnotThatLocksTheWrongWay) {
  Tie tie(GetParam());
  ASSERT_EQ(tie.table.size(), 1u);
  for (int k = 0; k < 5; ++k) tie.look(true, true);
  EXPECT_EQ(tie.faultsBeforeDone, 1);
}

}  // namespace
}  // namespace halsted
