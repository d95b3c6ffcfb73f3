/// What the haptic thread tells the panels of faults, and what it records of them.
#include "app/threads/haptic_thread.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

#include "haptics/limits.h"

namespace halsted::app {
namespace {

/// More force than the device can give is limited, which is no reason to say that the device is switched off.
TEST(HapticStatus, NamesOnlyFaultsThatCutTheForceAndTheRecordNamesAll) {
  const auto links = std::make_unique<Links>(std::array<ToolSample, kHands>{}, RenderSnapshot{}, render::Frame{}, State{});
  Hands hands{makeHand({}, Pose{}), makeHand({}, Pose{})};
  HapticOutcome outcome;
  std::thread thread([&] { runHaptic(hands, {Mover::kNobody, Mover::kNobody}, *links, outcome); });
  std::uint32_t shown = 0, recorded = 0;
  int limited = 0;                             // steps since a force was
  for (std::uint64_t step = 1; step <= 5000 && limited < 50; ++step) {
    for (LocalContact& c : links->contacts.back()) {
      c.step = step;
      c.touching = true;
      c.force = 20.0 * Vec3::UnitX();          // [N] reached little by little: 40 mN a tick
    }
    links->contacts.publish();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    links->hapticStatus.acquire();
    for (std::uint32_t faults : links->hapticStatus.front().status.faultCode) shown |= faults;
    for (HapticRecord record; links->hapticRecords.pop(record);)
      for (std::uint32_t faults : record.faults) recorded |= faults;
    limited += (recorded & haptics::kFaultMagnitude) != 0;
  }
  links->stop.store(true);
  thread.join();
  EXPECT_NE(recorded & haptics::kFaultMagnitude, 0u) << "nothing was limited";
  EXPECT_EQ(shown & ~haptics::kFaultCutMask, 0u);
}

}  // namespace
}  // namespace halsted::app
