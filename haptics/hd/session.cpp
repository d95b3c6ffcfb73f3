#include "haptics/hd/session.h"

namespace halsted::haptics::hd {

ThreadContext& thisThread() noexcept {
  static thread_local ThreadContext context;
  return context;
}

Session& Session::instance() {
  static Session& session = *new Session;
  return session;
}

void Session::raiseForceErrors(std::uint32_t bits, HHD device) noexcept {
  constexpr std::pair<std::uint32_t, HDerror> kCodes[] = {{kErrorForce, HD_FORCE_ERROR},
                                                          {kErrorMaxForce, HD_EXCEEDED_MAX_FORCE},
                                                          {kErrorImpulse, HD_EXCEEDED_MAX_FORCE_IMPULSE},
                                                          {kErrorVelocity, HD_EXCEEDED_MAX_VELOCITY},
                                                          {kErrorWarm, HD_WARM_MOTORS}};
  for (const auto& [bit, code] : kCodes)
    if (bits & bit) raise(code, device);
}

OpenDevice* Session::find(HHD handle) noexcept {
  return handle < kMaxDevices && devices[handle].isOpen() ? &devices[handle] : nullptr;
}

HHD Session::currentDevice() noexcept {
  const HHD own = thisThread().current;
  if (find(own)) return own;
  const HHD shared = static_cast<HHD>(chosen_.load(std::memory_order_acquire));
  return find(shared) ? shared : HD_INVALID_HANDLE;
}

void Session::makeCurrent(HHD handle) noexcept {
  thisThread().current = handle;
  std::uint64_t before = chosen_.load(std::memory_order_relaxed);
  if (thisThread().servo && find(static_cast<HHD>(before))) return;
  while (!chosen_.compare_exchange_weak(before, (((before >> 32) + 1) << 32) | handle, std::memory_order_acq_rel)) {}
}

void Session::followCurrent() noexcept {
  ThreadContext& thread = thisThread();
  const std::uint64_t chosen = chosen_.load(std::memory_order_acquire);
  const std::uint32_t count = static_cast<std::uint32_t>(chosen >> 32);
  if (count == thread.seen) return;
  thread.seen = count;
  thread.current = static_cast<HHD>(chosen);
}

Moment Session::now() noexcept {
  const ThreadContext& thread = thisThread();
  if (thread.servo) return thread.moment;
  return {monotonicNow(), thread.moment.tick, servo.running()};
}

void Session::endTick(const Moment& moment) noexcept {
  for (int i = 0; i < kMaxDevices; ++i)
    if (devices[i].isOpen() && devices[i].endTick(moment) != HD_SUCCESS) raise(HD_FRAME_ERROR, static_cast<HHD>(i));
}

void Session::relaxDevices() noexcept {
  for (OpenDevice& device : devices) device.relax();
}

}  // namespace halsted::haptics::hd
