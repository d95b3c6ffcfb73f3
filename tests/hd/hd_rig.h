#pragma once
/// A clean process-wide HD session for each test, and callbacks that are lambdas.
#include <HD/hd.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <vector>

namespace halsted::hdtest {

using Step = std::function<HDCallbackCode()>;
inline constexpr HDCallbackCode kDone = HD_CALLBACK_DONE, kContinue = HD_CALLBACK_CONTINUE;

inline HDCallbackCode HDCALLBACK runStep(void* step) { return (*static_cast<Step*>(step))(); }

inline HDSchedulerHandle schedule(Step& step, HDushort priority = HD_DEFAULT_SCHEDULER_PRIORITY) {
  return hdScheduleAsynchronous(runStep, &step, priority);
}

/// In the servo loop, once.
inline void onServo(const std::function<void()>& what) {
  Step step = [&] {
    what();
    return kDone;
  };
  hdScheduleSynchronous(runStep, &step, HD_DEFAULT_SCHEDULER_PRIORITY);
}

/// In `count` ticks of the servo loop; returns when they are over.
inline void inTicks(int count, const std::function<void(int)>& what) {
  int tick = 0;
  Step step = [&] {
    what(tick);
    return ++tick < count ? kContinue : kDone;
  };
  hdScheduleSynchronous(runStep, &step, HD_DEFAULT_SCHEDULER_PRIORITY);
}

/// All errors, the last one first.
inline std::vector<HDerror> drain() {
  std::vector<HDerror> codes;
  for (HDErrorInfo error = hdGetError(); HD_DEVICE_ERROR(error); error = hdGetError()) codes.push_back(error.errorCode);
  return codes;
}

class Hd : public ::testing::Test {
 protected:
  Hd() { reset(); }
  ~Hd() override {
    reset();
    for (const char* name : {"HALSTED_HD_CONFIG", "HALSTED_HD_DEVICES", "HALSTED_HD_MOTION", "HALSTED_HD_MOTION_LOOP"}) unsetenv(name);
  }

 private:
  static void reset() {
    hdStopScheduler();
    for (HHD device = 0; device < 16; ++device) hdDisableDevice(device);
    hdSetSchedulerRate(1000);
    drain();
  }
};

}  // namespace halsted::hdtest
