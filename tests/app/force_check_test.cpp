/// The force check of `halsted devices --test` in virtual time, on a Falcon model at the end of a loopback cable.
#include "app/force_check.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/haptics/usb/falcon_rig.h"

namespace halsted::app {
namespace {

struct CheckedFalcon : haptics::FalconRig {
  double time = 0.0;                           // [s]
  std::function<void()> meanwhile = [] {};     // every millisecond

  ForceCheck check() {
    const CheckClock clock{[this] { return static_cast<haptics::Nanoseconds>(time * 1e9); },
                           [this](haptics::Nanoseconds) {
                             time += 1e-3;
                             meanwhile();
                             bus.advance(1e-3);
                             device.serviceOnce();
                           }};
    return checkForces(device, 10.0, clock);
  }
  void silence(double seconds) { bus.faults(port).silentFor = seconds; }   // [s]
};

TEST(ForceCheck, PushesEachWayWithinItsBounds) {
  const ForceCheck check = CheckedFalcon().check();
  EXPECT_TRUE(check.passed);
  EXPECT_EQ(check.pushes.size(), 6u);
  EXPECT_EQ(check.interruptions, 0);
  EXPECT_GT(check.largestForce, 1.4);          // [N] of 1.5
  EXPECT_LE(check.largestForce, 1.8);
}

/// A cable or a computer that falters for some seconds: pushes are begun again until each was whole.
TEST(ForceCheck, OutlastsATransportThatFalters) {
  CheckedFalcon falcon;
  int tick = 0;
  falcon.meanwhile = [&] {
    if (++tick < 9000 && tick % 300 == 0) falcon.silence(20e-3);
  };
  const ForceCheck check = falcon.check();
  EXPECT_TRUE(check.passed);
  EXPECT_EQ(check.faults, 0u);
  EXPECT_GT(check.interruptions, 5);
}

/// The device falls silent for good in the midst of the check: no pass, the reason named, and not for ever.
TEST(ForceCheck, SaysWhenTheDeviceStaysSilent) {
  CheckedFalcon falcon;
  falcon.meanwhile = [&] {
    if (falcon.time > 2.0) falcon.silence(1.0);
  };
  const ForceCheck check = falcon.check();
  EXPECT_TRUE(check.ready);
  EXPECT_FALSE(check.passed);
  EXPECT_EQ(check.faults, haptics::kFaultDeviceSilent);
  EXPECT_EQ(check.interruptions, 1);
  EXPECT_LT(check.seconds, 12.0);              // [s]
}

/// It never stops faltering: given up after its patience.
TEST(ForceCheck, GivesUpOnATransportThatNeverStopsFaltering) {
  CheckedFalcon falcon;
  int tick = 0;
  falcon.meanwhile = [&] {
    if (++tick % 300 == 0) falcon.silence(20e-3);
  };
  const ForceCheck check = falcon.check();
  EXPECT_FALSE(check.passed);
  EXPECT_EQ(check.faults, haptics::kFaultDeviceSilent);
  EXPECT_LT(check.seconds, 50.0);              // [s]
}

}  // namespace
}  // namespace halsted::app
