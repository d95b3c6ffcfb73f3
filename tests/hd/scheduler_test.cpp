/// The scheduler: order, life and death of callbacks, start and stop, rates.
#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "tests/hd/hd_rig.h"

namespace halsted::hdtest {
namespace {

using Scheduler = Hd;
using namespace std::chrono_literals;

TEST_F(Scheduler, CallsInOrderOfPriorityThenOfComing) {
  std::string order;
  const auto say = [&](char c) { return Step([&order, c] { order += c; return kDone; }); };
  Step a = say('a'), b = say('b'), c = say('c'), d = say('d');
  schedule(a, 5);
  schedule(b, HD_MAX_SCHEDULER_PRIORITY);
  schedule(c, HD_MIN_SCHEDULER_PRIORITY);
  const HDSchedulerHandle last = schedule(d, 5);
  hdStartScheduler();
  hdWaitForCompletion(last, HD_WAIT_INFINITE);
  onServo([] {});
  EXPECT_EQ(order, "badc");
}

TEST_F(Scheduler, KeepsACallbackUntilItIsDone) {
  int calls = 0;
  Step step = [&] { return ++calls < 7 ? kContinue : kDone; };
  hdStartScheduler();
  const HDSchedulerHandle handle = schedule(step);
  EXPECT_TRUE(hdWaitForCompletion(handle, HD_WAIT_INFINITE));
  EXPECT_FALSE(hdWaitForCompletion(handle, HD_WAIT_CHECK_STATUS));
  EXPECT_TRUE(hdWaitForCompletion(handle, HD_WAIT_INFINITE));
  EXPECT_EQ(calls, 7);
  hdUnschedule(handle);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_OPERATION});
}

TEST_F(Scheduler, BlocksASynchronousCallUntilItIsDone) {
  hdStartScheduler();
  int calls = 0;
  const auto client = std::this_thread::get_id();
  inTicks(10, [&](int) {
    ++calls;
    EXPECT_NE(std::this_thread::get_id(), client);
  });
  EXPECT_EQ(calls, 10);
}

TEST_F(Scheduler, RunsASynchronousCallFromTheServoThreadAtOnce) {
  hdStartScheduler();
  std::string order;
  onServo([&] {
    order += 'a';
    onServo([&] { order += 'b'; });
    int left = 3;
    Step thrice = [&] { order += 'x'; return --left > 0 ? kContinue : kDone; };
    hdScheduleSynchronous(runStep, &thrice, HD_MIN_SCHEDULER_PRIORITY);
    order += 'c';
  });
  EXPECT_EQ(order, "abxxxc");
}

TEST_F(Scheduler, RunsASynchronousCallHereWhenItIsNotStarted) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  const auto client = std::this_thread::get_id();
  inTicks(3, [&](int) {
    EXPECT_EQ(std::this_thread::get_id(), client);
    hdBeginFrame(device);
    hdEndFrame(device);
  });
  EXPECT_TRUE(drain().empty());
}

TEST_F(Scheduler, TakesCallbacksBeforeItsStartAndKeepsThemOverAStop) {
  std::atomic<int> calls{0};
  Step step = [&] { ++calls; return kContinue; };
  const HDSchedulerHandle handle = schedule(step);
  std::this_thread::sleep_for(5ms);
  EXPECT_EQ(calls, 0);
  for (int life = 0; life < 3; ++life) {
    hdStartScheduler();
    hdStartScheduler();  // a second start changes nothing
    const int before = calls;
    while (calls < before + 5) std::this_thread::sleep_for(1ms);
    hdStopScheduler();
    hdStopScheduler();
    const int stopped = calls;
    std::this_thread::sleep_for(5ms);
    EXPECT_EQ(calls, stopped);
    EXPECT_TRUE(hdWaitForCompletion(handle, HD_WAIT_CHECK_STATUS));
  }
  hdUnschedule(handle);
  EXPECT_TRUE(drain().empty());
}

TEST_F(Scheduler, StopsAfterTheTickWhenACallbackAsks) {
  std::atomic<int> calls{0};
  Step stop = [&] { hdStopScheduler(); return kDone; };
  Step count = [&] { ++calls; return kContinue; };
  schedule(stop, HD_MAX_SCHEDULER_PRIORITY);
  const HDSchedulerHandle handle = schedule(count, HD_MIN_SCHEDULER_PRIORITY);
  hdStartScheduler();
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(calls, 1);
  hdStartScheduler();
  while (calls < 4) std::this_thread::sleep_for(1ms);
  hdUnschedule(handle);
}

TEST_F(Scheduler, LetsGoOfWhoWaitsWhenItStops) {
  std::atomic<bool> waiting{false}, answer{true};
  Step forever = [&] { waiting = true; return kContinue; };
  const HDSchedulerHandle handle = schedule(forever);
  hdStartScheduler();
  std::thread waiter([&] { answer = hdWaitForCompletion(handle, HD_WAIT_INFINITE) == HD_TRUE; });
  while (!waiting) std::this_thread::yield();
  std::this_thread::sleep_for(5ms);
  hdStopScheduler();
  waiter.join();
  EXPECT_FALSE(answer);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_OPERATION});
  EXPECT_FALSE(hdWaitForCompletion(handle, HD_WAIT_INFINITE));  // nothing runs that could finish it
  hdUnschedule(handle);
}

TEST_F(Scheduler, HasStoppedCallingWhatWasUnscheduled) {
  hdStartScheduler();
  for (int i = 0; i < 50; ++i) {
    auto alive = std::make_unique<std::atomic<int>>(0);
    std::atomic<int>* data = alive.get();
    Step step = [data] { ++*data; return kContinue; };
    const HDSchedulerHandle handle = schedule(step);
    while (*data < 2) std::this_thread::yield();
    hdUnschedule(handle);
    alive.reset();  // the address sanitizer sees a call after this
  }
  onServo([] {});
  EXPECT_TRUE(drain().empty());
}

TEST_F(Scheduler, UnschedulesFromTheCallbackItself) {
  hdStartScheduler();
  HDSchedulerHandle handle = 0;
  std::atomic<int> calls{0};
  Step step = [&] {
    ++calls;
    hdUnschedule(handle);
    return kContinue;
  };
  onServo([&] { handle = schedule(step); });
  EXPECT_TRUE(hdWaitForCompletion(handle, HD_WAIT_INFINITE));
  onServo([] {});
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(drain().empty());
}

TEST_F(Scheduler, SaysWhenItIsFullAndWhenThereIsNothingToCall) {
  Step step = [] { return kContinue; };
  std::vector<HDSchedulerHandle> handles;
  while (handles.size() < 2000) {
    const HDSchedulerHandle handle = schedule(step);
    if (handle == HD_INVALID_HANDLE) break;
    handles.push_back(handle);
  }
  EXPECT_GE(handles.size(), 500u);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_SCHEDULER_FULL});
  for (const HDSchedulerHandle handle : handles) hdUnschedule(handle);
  EXPECT_EQ(hdScheduleAsynchronous(nullptr, nullptr, 0), HD_INVALID_HANDLE);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_VALUE});
  EXPECT_FALSE(hdWaitForCompletion(123456789, HD_WAIT_CHECK_STATUS));
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_OPERATION});
}

TEST_F(Scheduler, TakesThreeRatesAndTellsThem) {
  for (const HDulong rate : {500ul, 2000ul, 1000ul}) {
    hdSetSchedulerRate(rate);
    HDint nominal = 0;
    hdGetIntegerv(HD_UPDATE_RATE, &nominal);
    EXPECT_EQ(nominal, static_cast<HDint>(rate));
  }
  EXPECT_TRUE(drain().empty());
  for (const HDulong rate : {0ul, 100ul, 1001ul, 1000000ul}) {
    hdSetSchedulerRate(rate);
    EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_VALUE});
  }
}

TEST_F(Scheduler, CountsTheTimeSinceTheStartOfTheTick) {
  EXPECT_EQ(hdGetSchedulerTimeStamp(), 0.0);
  hdStartScheduler();
  onServo([] {
    const double first = hdGetSchedulerTimeStamp();
    const auto until = std::chrono::steady_clock::now() + 300us;
    while (std::chrono::steady_clock::now() < until) {}
    const double second = hdGetSchedulerTimeStamp();
    EXPECT_GE(first, 0.0);
    EXPECT_GE(second - first, 300e-6);
  });
}

TEST_F(Scheduler, ServesManyThreadsAtOnce) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdStartScheduler();
  Step servo = [&] {
    hdBeginFrame(device);
    double force[3] = {0.1, 0, 0};
    hdSetDoublev(HD_CURRENT_FORCE, force);
    hdEndFrame(device);
    return kContinue;
  };
  const HDSchedulerHandle handle = schedule(servo, HD_MAX_SCHEDULER_PRIORITY);
  std::atomic<int> total{0};
  std::vector<std::thread> clients;
  for (int t = 0; t < 4; ++t)
    clients.emplace_back([&] {
      for (int i = 0; i < 25; ++i) {
        int local = 0;
        double position[3];
        onServo([&] { ++local; });
        hdGetDoublev(HD_CURRENT_POSITION, position);
        total += local;
      }
    });
  for (std::thread& client : clients) client.join();
  hdUnschedule(handle);
  EXPECT_EQ(total, 100);
  EXPECT_TRUE(drain().empty());
}

}  // namespace
}  // namespace halsted::hdtest
