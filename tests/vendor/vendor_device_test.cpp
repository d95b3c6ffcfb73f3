/// The vendor driver loads a libHD.so at run time: our own, which is the same interface over the virtual Touch, and one whose device
/// breaks. Real time, since the vendor's library has its own thread; what is asserted is order and value, not punctuality.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "haptics/hand_loop.h"
#include "haptics/vendor/vendor_device.h"

namespace halsted::haptics {
namespace {

class VendorTest : public ::testing::Test {
 protected:
  void use(const char* library, const char* fault = "") {
    setenv("HALSTED_VENDOR_LIBHD", library, 1);
    setenv("HALSTED_FAULTY_VENDOR", fault, 1);
    faulty<void>("faultyVendorForget");
  }
  /// Asks the faulty library itself.
  template <typename Result> static Result faulty(const char* question) {
    static void* library = dlopen(HALSTED_FAULTY_VENDOR_LIBRARY, RTLD_NOW);
    return reinterpret_cast<Result (*)()>(dlsym(library, question))();
  }
  void TearDown() override { unsetenv("HALSTED_VENDOR_LIBHD"); }

  /// One tick of the hand that holds it, a millisecond of real time.
  void tick(VendorDevice& device, const Vec3& force = Vec3::Zero()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    contact.step = ++index;
    contact.touching = true;
    contact.force = force;
    haptics::tick(device, config, contact, {}, index, state, output);
  }
  template <typename Seen>
  bool within(VendorDevice& device, int ticks, const Vec3& force, Seen&& seen) {
    for (int i = 0; i < ticks; ++i) {
      tick(device, force);
      if (seen()) return true;
    }
    return false;
  }
  bool fault(std::uint32_t bit) const { return (output.faults & bit) != 0; }

  HandLoopConfig config;
  HandLoopState state;
  HandLoopOutput output;
  LocalContact contact;
  std::uint64_t index = 0;
};

TEST_F(VendorTest, OurOwnLibraryIsDrivenAsTheVendorsOne) {
  use(HALSTED_LIBHD);
  auto opened = VendorDevice::open("");
  ASSERT_TRUE(opened.device) << problemText(opened.problem);
  VendorDevice& device = *opened.device;
  EXPECT_EQ(device.library(), HALSTED_LIBHD);
  EXPECT_EQ(device.model(), "Touch");
  EXPECT_NEAR(device.limits().peakForce, 3.3, 1e-9);
  EXPECT_NEAR(device.limits().continuousForce, 0.88, 1e-9);
  ASSERT_TRUE(within(device, 3000, Vec3::Zero(), [&] { return !fault(kFaultDeviceSilent | kFaultDeviceGone); }));
  const std::uint64_t before = device.servoTicks();
  for (int i = 0; i < 300; ++i) tick(device);
  EXPECT_GT(device.servoTicks(), before);
  // The virtual hand holds the stylus; a force moves it the way it points.
  const Vec3 rest = output.sample.pose.position;
  EXPECT_TRUE(within(device, 3000, Vec3(1.2, 0.0, 0.0), [&] { return output.sample.pose.position.x() > rest.x() + 0.5e-3; }));
}

TEST_F(VendorTest, AMissingLibraryAndAnIncompleteOneAreToldApart) {
  use("/nonexistent/libHD.so");
  EXPECT_EQ(VendorDevice::open("").problem, DeviceProblem::kVendorLibraryMissing);
  use("libm.so.6");
  EXPECT_EQ(VendorDevice::open("").problem, DeviceProblem::kVendorLibraryUnusable);
}

TEST_F(VendorTest, AnUnknownNameIsRefusedByTheLibrary) {
  use(HALSTED_LIBHD);
  auto opened = VendorDevice::open("no such device");
  EXPECT_FALSE(opened.device);
  EXPECT_EQ(opened.problem, DeviceProblem::kVendorDeviceRefused);
}

TEST_F(VendorTest, NumbersThatAreNoneCutTheForceAndPassOver) {
  use(HALSTED_FAULTY_VENDOR_LIBRARY, "nan");
  auto opened = VendorDevice::open("");
  ASSERT_TRUE(opened.device);
  Vec3 last = Vec3::Zero();                    // [m]
  ASSERT_TRUE(within(*opened.device, 3000, Vec3(0.8, 0.0, 0.0), [&] {
    if (fault(kFaultBadReading)) return true;
    last = output.sample.pose.position;
    return false;
  }));
  EXPECT_EQ(output.force.norm(), 0.0);
  EXPECT_GT(last.norm(), 5e-3) << "it had been read before";
  EXPECT_LT((output.sample.pose.position - last).norm(), 2.0 * config.rejoinSpeed * 1e-3) << "the last good pose stands, but for the walk to it";
  EXPECT_TRUE(within(*opened.device, 5000, Vec3(0.8, 0.0, 0.0), [&] { return output.force.norm() > 0.7; })) << "and it comes back";
}

/// A device with the thread that a session gives it.
class Served {
 public:
  explicit Served(VendorDevice& device) : thread_([this, &device] { device.serve(stop_); }) {}
  ~Served() {
    stop_.store(true);
    thread_.join();
  }

 private:
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

TEST_F(VendorTest, ALostDeviceIsGoneWithZeroForceAndTheSessionMayWaitForIt) {
  use(HALSTED_FAULTY_VENDOR_LIBRARY, "lost");
  auto opened = VendorDevice::open("");
  ASSERT_TRUE(opened.device);
  const Served served(*opened.device);
  ASSERT_TRUE(within(*opened.device, 3000, Vec3(0.8, 0.0, 0.0), [&] { return fault(kFaultDeviceGone); }));
  EXPECT_EQ(output.force.norm(), 0.0);
  EXPECT_EQ(opened.device->status().problem, DeviceProblem::kTransferFailed);
  EXPECT_TRUE(opened.device->mayReturn());
  EXPECT_FALSE(within(*opened.device, 1200, Vec3(0.8, 0.0, 0.0), [&] { return !fault(kFaultDeviceGone) || output.force.norm() > 0.0; }))
      << "the library refuses to open it again";
}

TEST_F(VendorTest, ADeviceThatComesBackIsOpenedAgainInTheOrderOfTheInterface) {
  use(HALSTED_FAULTY_VENDOR_LIBRARY, "replug");
  auto opened = VendorDevice::open("");
  ASSERT_TRUE(opened.device);
  {
    const Served served(*opened.device);
    ASSERT_TRUE(within(*opened.device, 3000, Vec3(0.8, 0.0, 0.0), [&] { return fault(kFaultDeviceGone); }));
    ASSERT_TRUE(within(*opened.device, 6000, Vec3(0.8, 0.0, 0.0), [&] { return output.faults == 0 && output.force.norm() > 0.7; }));
    EXPECT_NEAR(opened.device->read(0.0).pose.position.x(), 20e-3, 1e-12) << "where it stands now";
    EXPECT_EQ(opened.device->status().stage, DeviceStage::kReady);
  }
  opened.device.reset();
  EXPECT_STREQ(faulty<const char*>("faultyVendorCalls"),
               "init schedule start stop unschedule disable init init init schedule start stop unschedule disable ");
}

TEST_F(VendorTest, AnotherDeviceUnderItsNameIsNotTakenForIt) {
  use(HALSTED_FAULTY_VENDOR_LIBRARY, "swap");
  auto opened = VendorDevice::open("left");
  ASSERT_TRUE(opened.device);
  EXPECT_EQ(opened.device->serial(), "SERIAL-LEFT");
  bool sawOther = false;
  {
    const Served served(*opened.device);
    ASSERT_TRUE(within(*opened.device, 3000, Vec3(0.8, 0.0, 0.0), [&] { return fault(kFaultDeviceGone); }));
    ASSERT_TRUE(within(*opened.device, 6000, Vec3(0.8, 0.0, 0.0), [&] {
      sawOther = sawOther || opened.device->status().problem == DeviceProblem::kNotAttached;
      return output.faults == 0;
    }));
  }
  EXPECT_TRUE(sawOther);
  opened.device.reset();
  EXPECT_STREQ(faulty<const char*>("faultyVendorCalls"),
               "init schedule start stop unschedule disable init init disable init schedule start stop unschedule disable ");
}

TEST_F(VendorTest, OfTwoDevicesOnlyTheOneThatTheErrorNamesIsLost) {
  use(HALSTED_FAULTY_VENDOR_LIBRARY, "lost-right");
  auto left = VendorDevice::open("left"), right = VendorDevice::open("right");
  ASSERT_TRUE(left.device && right.device);
  EXPECT_NE(left.device->serial(), right.device->serial());
  ASSERT_TRUE(within(*right.device, 3000, Vec3::Zero(), [&] { return fault(kFaultDeviceGone); }));
  EXPECT_NEAR(right.device->read(0.0).pose.position.x(), 110e-3, 1e-12);
  EXPECT_EQ(left.device->status().stage, DeviceStage::kReady) << "though its callback was the one that found the error";
  EXPECT_TRUE(left.device->read(1e-3).connected);
  right.device.reset();
  EXPECT_TRUE(within(*left.device, 5000, Vec3(0.8, 0.0, 0.0), [&] { return output.faults == 0 && output.force.norm() > 0.7; }));
}

TEST_F(VendorTest, AServoThreadThatStallsIsSilentThenGoesOn) {
  use(HALSTED_FAULTY_VENDOR_LIBRARY, "stall");
  auto opened = VendorDevice::open("");
  ASSERT_TRUE(opened.device);
  ASSERT_TRUE(within(*opened.device, 3000, Vec3::Zero(), [&] { return output.faults == 0; }));
  EXPECT_TRUE(within(*opened.device, 5000, Vec3(0.8, 0.0, 0.0), [&] { return fault(kFaultDeviceSilent) && output.force.norm() == 0.0; }));
  EXPECT_TRUE(within(*opened.device, 5000, Vec3(0.8, 0.0, 0.0), [&] { return output.force.norm() > 0.7; }));
}

/// The haptic thread stops: the vendor's servo thread lets the force go by itself.
TEST_F(VendorTest, AHapticThreadThatStopsLetsGo) {
  use(HALSTED_FAULTY_VENDOR_LIBRARY);
  auto opened = VendorDevice::open("");
  ASSERT_TRUE(opened.device);
  ASSERT_TRUE(within(*opened.device, 5000, Vec3(0.8, 0.0, 0.0), [&] { return output.force.norm() > 0.7; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_EQ(faulty<double>("faultyVendorPush"), 0.0);
}

}  // namespace
}  // namespace halsted::haptics
