/// Frames: what a tick may do with a device.
#include <array>

#include "tests/hd/hd_rig.h"

namespace halsted::hdtest {
namespace {

using Frames = Hd;
using Point = std::array<double, 3>;

Point read(HDenum name) {
  Point point{-1, -2, -3};
  hdGetDoublev(name, point.data());
  return point;
}

void setForce(const Point& force) { hdSetDoublev(HD_CURRENT_FORCE, force.data()); }

TEST_F(Frames, OpenInOneCallbackAndCloseInAnotherOfTheSameTick) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  int closed = 0;
  Point seen{};
  Step open = [&] { hdBeginFrame(device); return kContinue; };
  Step use = [&] { setForce({0.1, 0.2, 0.3}); return kContinue; };
  Step close = [&] {
    seen = read(HD_CURRENT_FORCE);
    hdEndFrame(device);
    return ++closed < 20 ? kContinue : kDone;
  };
  const HDSchedulerHandle last = schedule(close, HD_MIN_SCHEDULER_PRIORITY);
  const HDSchedulerHandle middle = schedule(use);
  const HDSchedulerHandle first = schedule(open, HD_MAX_SCHEDULER_PRIORITY);
  hdStartScheduler();
  hdWaitForCompletion(last, HD_WAIT_INFINITE);
  hdUnschedule(first);
  hdUnschedule(middle);
  hdStopScheduler();
  EXPECT_EQ(seen, (Point{0.1, 0.2, 0.3}));
  for (const HDerror code : drain()) EXPECT_EQ(code, HD_FRAME_ERROR);  // at most the ticks after `close` had gone
  EXPECT_EQ(closed, 20);
}

TEST_F(Frames, NestInATick) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdStartScheduler();
  onServo([&] {
    hdBeginFrame(device);
    setForce({1, 0, 0});
    hdBeginFrame(device);
    EXPECT_EQ(read(HD_CURRENT_FORCE), (Point{1, 0, 0}));   // not a new frame: nothing begins at zero again
    setForce({2, 0, 0});
    hdEndFrame(device);
    EXPECT_EQ(read(HD_CURRENT_FORCE), (Point{2, 0, 0}));
    hdEndFrame(device);
    EXPECT_TRUE(drain().empty());
    hdEndFrame(device);
    EXPECT_EQ(drain(), std::vector<HDerror>{HD_ILLEGAL_END});
  });
}

TEST_F(Frames, OneADeviceATickUnlessTheLimitIsOff) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdStartScheduler();
  const auto twice = [&] {
    for (int i = 0; i < 2; ++i) {
      hdBeginFrame(device);
      hdEndFrame(device);
    }
  };
  onServo([&] {
    twice();
    EXPECT_EQ(drain(), (std::vector<HDerror>{HD_ILLEGAL_END, HD_ILLEGAL_BEGIN}));
  });
  hdDisable(HD_ONE_FRAME_LIMIT);
  onServo([&] {
    twice();
    EXPECT_TRUE(drain().empty());
  });
}

TEST_F(Frames, SeveralDevicesInATick) {
  const HHD left = hdInitDevice("left"), right = hdInitDevice("right");
  hdStartScheduler();
  onServo([&] {
    hdBeginFrame(left);
    hdBeginFrame(right);
    hdMakeCurrentDevice(left);
    setForce({1, 0, 0});
    hdMakeCurrentDevice(right);
    setForce({2, 0, 0});
    hdMakeCurrentDevice(left);
    EXPECT_EQ(read(HD_CURRENT_FORCE), (Point{1, 0, 0}));
    hdEndFrame(left);
    EXPECT_EQ(hdGetCurrentDevice(), left);
    hdMakeCurrentDevice(right);
    EXPECT_EQ(read(HD_CURRENT_FORCE), (Point{2, 0, 0}));
    hdEndFrame(right);
    EXPECT_TRUE(drain().empty());
  });
}

TEST_F(Frames, LeftOpenAtTheEndOfATickAreDroppedWithAnErrorOfTheirDevice) {
  hdInitDevice("left");
  const HHD right = hdInitDevice("right");
  hdStartScheduler();
  onServo([&] { hdBeginFrame(right); });
  onServo([] {});
  const HDErrorInfo error = hdGetError();
  EXPECT_EQ(error.errorCode, static_cast<HDerror>(HD_FRAME_ERROR));
  EXPECT_EQ(error.hHD, right);
  onServo([&] {
    hdBeginFrame(right);
    hdEndFrame(right);
  });
  EXPECT_TRUE(drain().empty());
}

TEST_F(Frames, BeginWithNoForceAndKeepTheLastOne) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdStartScheduler();
  Point before{};
  inTicks(5, [&](int tick) {
    hdBeginFrame(device);
    EXPECT_EQ(read(HD_CURRENT_FORCE), (Point{0, 0, 0}));
    if (tick > 0) {
      EXPECT_EQ(read(HD_LAST_FORCE), (Point{0.01 * tick, 0, 0}));
      EXPECT_EQ(read(HD_LAST_POSITION), before);
    }
    setForce({0.01 * (tick + 1), 0, 0});
    before = read(HD_CURRENT_POSITION);
    hdEndFrame(device);
  });
  EXPECT_TRUE(drain().empty());
}

TEST_F(Frames, SetNothingOutsideThemButReadAnywhere) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  EXPECT_EQ(read(HD_CURRENT_POSITION)[1], 0.0);
  HDint buttons = -1;
  hdGetIntegerv(HD_CURRENT_BUTTONS, &buttons);
  EXPECT_EQ(buttons, 0);
  EXPECT_TRUE(drain().empty());
  setForce({1, 0, 0});
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_FRAME_ERROR});
  hdBeginFrame(device);  // on a client's own thread, without a scheduler
  setForce({1, 0, 0});
  hdEndFrame(device);
  hdBeginFrame(device);
  hdEndFrame(device);
  EXPECT_TRUE(drain().empty());
}

TEST_F(Frames, OfAClosedDeviceRaiseAnErrorAndLeaveTheAnswerAlone) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdStartScheduler();
  int after = 0;
  Step step = [&] {
    hdBeginFrame(device);
    Point point{7, 7, 7};
    hdGetDoublev(HD_CURRENT_POSITION, point.data());
    hdEndFrame(device);
    if (point[0] == 7) ++after;
    return after < 5 ? kContinue : kDone;
  };
  const HDSchedulerHandle handle = schedule(step);
  hdDisableDevice(device);  // while its callback is still scheduled
  EXPECT_TRUE(hdWaitForCompletion(handle, HD_WAIT_INFINITE));
  EXPECT_EQ(after, 5);
  for (const HDerror code : drain()) EXPECT_TRUE(code == HD_BAD_HANDLE || code == HD_INVALID_OPERATION) << code;
}

}  // namespace
}  // namespace halsted::hdtest
