#pragma once
/// Everything that one process has of the HD API: devices, errors, schedule, servo thread, and which device is current where.
/// One object, made by the first call and never destroyed: callbacks may still run while the program exits.
#include "haptics/hd/error_stack.h"
#include "haptics/hd/open_device.h"
#include "haptics/hd/operation_table.h"
#include "haptics/hd/servo.h"

namespace halsted::haptics::hd {

/// What a thread knows. A client thread sees the device that it made current itself, else the one that any client made current last;
/// the servo thread sees what its callbacks made current, until a client makes another one current.
struct ThreadContext {
  HHD current = HD_INVALID_HANDLE;
  std::uint32_t seen = 0;                      // count of client choices when `current` was set
  bool servo = false;
  Moment moment;                               // of the tick that runs on this thread; tick 0: none
  Nanoseconds localStart = 0;                  // of a callback that runs here because no servo loop does
};
ThreadContext& thisThread() noexcept;

class Session {
 public:
  static constexpr int kMaxDevices = 16;

  static Session& instance();

  std::array<OpenDevice, kMaxDevices> devices;
  ErrorStack errors;
  OperationTable operations;
  Servo servo{*this};
  InheritingMutex opening;                     // held over hdInitDevice and hdDisableDevice

  void raise(HDerror code) noexcept { errors.push(code, currentDevice()); }
  void raise(HDerror code, HHD device) noexcept { errors.push(code, device); }
  /// Pushes what a frame reported in bits.
  void raiseForceErrors(std::uint32_t bits, HHD device) noexcept;

  /// HD_INVALID_HANDLE when there is none.
  HHD currentDevice() noexcept;
  void makeCurrent(HHD) noexcept;
  /// Servo thread, at the start of a tick: what clients chose meanwhile.
  void followCurrent() noexcept;
  OpenDevice* find(HHD) noexcept;

  Moment now() noexcept;
  void endTick(const Moment&) noexcept;
  void relaxDevices() noexcept;

 private:
  Session() = default;

  std::atomic<std::uint64_t> chosen_{HD_INVALID_HANDLE};  // high half: count of choices; low half: handle
};

}  // namespace halsted::haptics::hd
