#pragma once
/// The servo thread: an absolute schedule, callbacks in order, then what the tick owes the devices. Start and stop: client threads;
/// a callback may ask for the stop, which then comes after its tick.
#include <HD/hdScheduler.h>

#include <atomic>

#include "haptics/hd/clock.h"
#include "haptics/hd/lock.h"
#include "haptics/hd/operation_table.h"

namespace halsted::haptics::hd {

class Session;

class Servo {
 public:
  explicit Servo(Session& session) noexcept : session_(session) {}

  /// False when the thread could not be made. Starting a running one changes nothing.
  bool start() noexcept;
  void stop() noexcept;
  bool running() const noexcept { return running_.load(std::memory_order_acquire); }

  bool setRate(HDulong hertz) noexcept;        // 500, 1000 or 2000
  unsigned rate() const noexcept { return rate_.load(std::memory_order_relaxed); }
  Nanoseconds period() const noexcept { return kSecond / rate(); }
  /// One over the time between the starts of the last two ticks; 0 when it does not run.
  double measuredRate() const noexcept;        // [1/s]
  /// Since the start of the running tick, or of the last one for other threads.
  double sinceTick() const noexcept;           // [s]
  std::uint64_t newTick() noexcept { return ticks_.fetch_add(1, std::memory_order_relaxed) + 1; }

 private:
  static void* threadMain(void* self);
  void join() noexcept;
  void loop() noexcept;
  void tick(Nanoseconds scheduled) noexcept;
  void runCallbacks() noexcept;

  Session& session_;
  InheritingMutex lifecycle_;                  // start, stop and join; never taken by the servo thread
  pthread_t thread_{};
  bool exists_ = false;                        // thread_ is to be joined
  std::atomic<bool> running_{false}, stop_{false};
  std::atomic<unsigned> rate_{1000};           // [1/s]
  std::atomic<std::uint64_t> ticks_{0};
  std::atomic<Nanoseconds> tickStart_{0}, interval_{0};
  OperationTable::Order order_;                // servo thread only
};

}  // namespace halsted::haptics::hd
