/// IHapticDevice: one device, two threads. What happened in the ticks is told in the order in which it happened, once on each thread.
#include <HDU/hduHapticDevice.h>

#include <cstring>
#include <string>

#include "tests/hd/hd_rig.h"
#include "tests/support/process.h"

namespace halsted::hdtest {
namespace {

using Device = IHapticDevice;
using State = IHapticDevice::IHapticDeviceState;

struct Heard {
  std::vector<Device::EventType> events;
  HDerror error = HD_SUCCESS;
};

void hear(Device::EventType event, const State* const state, void* heard) {
  static_cast<Heard*>(heard)->events.push_back(event);
  if (event == Device::DEVICE_ERROR) static_cast<Heard*>(heard)->error = state->getLastError().errorCode;
}

class HapticDevice : public Hd {
 protected:
  void open(const std::string& motion = "") {
    if (!motion.empty()) {
      testing::writeText(folder_.file("hand.csv"), motion);
      setenv("HALSTED_HD_MOTION", folder_.file("hand.csv").c_str(), 1);
    }
    const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
    haptic = Device::create(Device::HAPTIC_THREAD_INTERFACE, device);
    graphic = Device::create(Device::GRAPHIC_THREAD_INTERFACE, device);
    for (int event = 0; event < Device::NUM_EVENT_TYPES; ++event) {
      haptic->setCallback(static_cast<Device::EventType>(event), hear, &onServoThread);
      graphic->setCallback(static_cast<Device::EventType>(event), hear, &onThisThread);
    }
    hdStartScheduler();
  }
  void ticks(int count, const std::function<void(int)>& what = [](int) {}) {
    inTicks(count, [&](int tick) {
      haptic->beginUpdate(nullptr);
      what(tick);
      haptic->endUpdate(nullptr);
    });
  }
  void picture() const {
    graphic->beginUpdate(haptic);
    graphic->endUpdate(haptic);
  }
  ~HapticDevice() override {
    Device::destroy(haptic);
    Device::destroy(graphic);
    EXPECT_EQ(graphic, nullptr);
  }

  testing::TemporaryFolder folder_;
  Device *haptic = nullptr, *graphic = nullptr;
  Heard onServoThread, onThisThread;
};

TEST_F(HapticDevice, TheGraphicThreadSeesWhatTheServoThreadSaw) {
  open("t_s,x_mm,y_mm,z_mm\n0,12,3,-4\n");
  const HDdouble shifted[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1};
  graphic->getCurrentState()->setParentCumulativeTransform(shifted);
  int mark = 0;
  ticks(5, [&](int) {
    State& state = *haptic->getCurrentState();
    state.setProxyPosition(hduVector3Dd(1, 2, 3));
    state.setContactData(&mark);
  });
  picture();
  const State& seen = *graphic->getCurrentState();
  EXPECT_NEAR(seen.getPosition()[0], 12.0, 0.1);
  EXPECT_EQ(seen.getTransform()[12], seen.getPosition()[0]);
  EXPECT_TRUE(seen.getProxyPosition() == hduVector3Dd(1, 2, 3));
  EXPECT_EQ(seen.getContactData(), &mark);
  EXPECT_EQ(seen.getParentCumulativeTransform()[12], 5.0) << "the way to the world is each interface's own";
  EXPECT_EQ(haptic->getCurrentState()->getParentCumulativeTransform()[12], 0.0);
  EXPECT_TRUE(drain().empty());
}

TEST_F(HapticDevice, EventsAreToldOnceOnEachThreadInTheirOrder) {
  open("t_s,x_mm,y_mm,z_mm,buttons\n0,0,0,0,0\n0.02,0,0,0,1\n0.04,0,0,0,3\n0.06,0,0,0,2\n0.08,0,0,0,0\n9,0,0,0,0\n");
  ticks(150, [&](int tick) { haptic->getCurrentState()->setIsInContact(tick >= 100 && tick < 120); });
  EXPECT_TRUE(onThisThread.events.empty()) << "not before it is updated";
  picture();
  picture();
  const std::vector<Device::EventType> expected = {Device::BUTTON_1_DOWN, Device::BUTTON_2_DOWN, Device::BUTTON_1_UP,
                                                   Device::BUTTON_2_UP,   Device::MADE_CONTACT,  Device::LOST_CONTACT};
  EXPECT_EQ(onServoThread.events, expected);
  EXPECT_EQ(onThisThread.events, expected);
}

TEST_F(HapticDevice, ErrorsOfATickAreAnEvent) {
  open();
  hdEnable(HD_FORCE_OUTPUT);
  hdDisable(HD_MAX_FORCE_CLAMPING);
  ticks(3, [](int) { hdSetDoublev(HD_CURRENT_FORCE, hduVector3Dd(0, 0, 5)); });
  picture();
  EXPECT_EQ(onServoThread.error, static_cast<HDerror>(HD_EXCEEDED_MAX_FORCE));
  EXPECT_EQ(onThisThread.error, static_cast<HDerror>(HD_EXCEEDED_MAX_FORCE));
  EXPECT_TRUE(drain().empty()) << "it takes them off the stack";
}

TEST_F(HapticDevice, AProgramThatNeverLooksLosesTheOldestEventsOnly) {
  open();
  ticks(201, [&](int tick) { haptic->getCurrentState()->setIsInContact(tick % 2 == 1); });
  picture();
  ASSERT_EQ(onThisThread.events.size(), 64u);
  EXPECT_EQ(onThisThread.events.front(), Device::MADE_CONTACT);
  EXPECT_EQ(onThisThread.events.back(), Device::LOST_CONTACT);
  EXPECT_EQ(onServoThread.events.size(), 200u);
}

}  // namespace
}  // namespace halsted::hdtest
