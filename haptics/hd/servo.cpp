#include "haptics/hd/servo.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "haptics/hd/session.h"

namespace halsted::haptics::hd {

namespace {

constexpr int kFifoPriority = 80;

/// Says once a process why the servo loop may be late.
void askForPriority() noexcept {
  const int refused = becomeRealtime(kFifoPriority);
  static std::atomic<bool> said{false};
  if (refused == 0 || said.exchange(true) || std::getenv("HALSTED_HD_QUIET")) return;
  std::fprintf(stderr, "halsted HD: the servo loop runs without real-time priority (%s); allow it with an rtprio limit of %d\n",
               std::strerror(refused), kFifoPriority);
}

}  // namespace

bool Servo::start() noexcept {
  if (thisThread().servo) return true;
  const Hold hold(lifecycle_);
  if (exists_ && !stop_.load() && running()) return true;
  join();
  stop_.store(false);
  interval_.store(0);
  running_.store(true, std::memory_order_release);
  session_.operations.setServed(true);
  session_.relaxDevices();
  exists_ = pthread_create(&thread_, nullptr, &Servo::threadMain, this) == 0;
  if (exists_) return true;
  running_.store(false, std::memory_order_release);
  session_.operations.setServed(false);
  return false;
}

void Servo::stop() noexcept {
  stop_.store(true);
  if (thisThread().servo) return;
  const Hold hold(lifecycle_);
  stop_.store(true);  // a start may have come first
  join();
}

void Servo::join() noexcept {
  if (!exists_) return;
  pthread_join(thread_, nullptr);
  exists_ = false;
}

bool Servo::setRate(HDulong hertz) noexcept {
  if (hertz != 500 && hertz != 1000 && hertz != 2000) return false;
  rate_.store(static_cast<unsigned>(hertz), std::memory_order_relaxed);
  return true;
}

double Servo::measuredRate() const noexcept {
  const Nanoseconds interval = interval_.load(std::memory_order_relaxed);
  if (!running()) return 0.0;
  return interval > 0 ? 1.0 / seconds(interval) : static_cast<double>(rate());
}

double Servo::sinceTick() const noexcept {
  const Nanoseconds start = tickStart_.load(std::memory_order_relaxed);
  return running() && start > 0 ? seconds(monotonicNow() - start) : 0.0;
}

void* Servo::threadMain(void* self) {
  Servo& servo = *static_cast<Servo*>(self);
  pthread_setname_np(pthread_self(), "hd-servo");
  thisThread() = {};
  thisThread().servo = true;
  touchStack();
  askForPriority();
  servo.loop();
  servo.session_.relaxDevices();
  servo.running_.store(false, std::memory_order_release);
  servo.tickStart_.store(0);
  servo.session_.operations.setServed(false);
  return nullptr;
}

void Servo::loop() noexcept {
  Nanoseconds next = monotonicNow();
  Nanoseconds before = 0;
  while (!stop_.load(std::memory_order_relaxed)) {
    const Nanoseconds step = period();
    next += step;
    const Nanoseconds late = monotonicNow() - next;
    if (late > 0) next += late / step * step;   // whole periods are skipped, the grid stays
    sleepUntil(next);
    const Nanoseconds now = monotonicNow();
    if (before > 0) interval_.store(now - before, std::memory_order_relaxed);
    before = now;
    tickStart_.store(now, std::memory_order_relaxed);
    tick(next);
  }
}

void Servo::tick(Nanoseconds scheduled) noexcept {
  ThreadContext& thread = thisThread();
  thread.moment = {scheduled, newTick(), true};
  session_.followCurrent();
  runCallbacks();
  session_.endTick(thread.moment);
}

void Servo::runCallbacks() noexcept {
  ThreadContext& thread = thisThread();
  const int count = session_.operations.copyOrder(order_);
  for (int i = 0; i < count; ++i) {
    Operation operation;
    if (!session_.operations.begin(order_[i], operation)) continue;
    const HHD own = thread.current;
    if (operation.synchronous) thread.current = operation.device;
    const HDCallbackCode code = operation.callback(operation.userData);
    const HHD left = thread.current;
    if (operation.synchronous) thread.current = own;
    session_.operations.end(order_[i], code, left);
  }
}

}  // namespace halsted::haptics::hd
