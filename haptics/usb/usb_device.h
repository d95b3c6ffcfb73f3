#pragma once
/// A device on a USB cable: the haptic tick on one side, the cable on the other, three carriers between them.
///   haptic thread   read, write: no system call at all; they take the newest reading and leave the newest force
///   service thread  serve: find, open, bring up, home, exchange packets, and begin again after the cable was pulled
/// Force is zero from the first tick after a failed transfer, after 10 ms without a reading, while not homed, and when the haptic
/// thread has not written for 10 ms.
#include <atomic>
#include <memory>
#include <string>

#include "haptics/carriers/triple_buffer.h"
#include "haptics/device.h"
#include "haptics/usb/usb.h"

namespace halsted::haptics {

/// What a packet said.
struct UsbMeasurement {
  Pose pose;
  double jaw = 1.0;                            // [1] where the user wants the jaws
  std::uint32_t presses = 0;
  bool calibrated = false;
  DeviceLimits limits;
};

/// `reading`: the measurement is whole and new. `broken` counts frames and stray bytes that were dropped on the way to it.
struct PacketOutcome { bool reading = false; int broken = 0; };

struct UsbPipes { int interfaces = 1; std::uint8_t in = 0x81, out = 0x02; };

/// What differs between kinds of device. Service thread, but for `kind`.
class UsbProtocol {
 public:
  virtual ~UsbProtocol() = default;
  virtual const char* kind() const noexcept = 0;
  virtual bool matches(const UsbDeviceInfo&) const noexcept = 0;
  virtual UsbPipes pipes() const noexcept = 0;
  virtual DeviceLimits limits() const noexcept = 0;               // before the first measurement
  virtual DeviceProblem notCalibrated() const noexcept { return DeviceProblem::kNeedsHoming; }
  /// Blocking; the link is fresh. Returns what keeps the device from answering.
  virtual DeviceProblem bringUp(UsbLink&) = 0;
  virtual PacketOutcome received(std::span<const std::uint8_t> packet, UsbMeasurement& measurement) noexcept = 0;
  /// The packet that asks for this force [N], device frame. `enabled` false: no force at all.
  virtual std::size_t command(const Vec3& force, bool enabled, std::span<std::uint8_t> packet) noexcept = 0;
};

/// Which one of several: by serial number, else by the port it is plugged into; both empty: the first that matches.
struct UsbBinding { std::string serial, port; };

struct UsbCounters { std::uint64_t readings = 0, corrupt = 0, failed = 0, opened = 0, repeated = 0; };

class UsbDevice final : public Device, private UsbStreamOwner {
 public:
  UsbDevice(std::shared_ptr<UsbBus>, std::unique_ptr<UsbProtocol>, UsbBinding = {});
  ~UsbDevice() override;

  DeviceReading read(double dt) noexcept override;                // [s]
  bool write(const Vec3& force) noexcept override;                // [N]
  DeviceLimits limits() const noexcept override { return measured_.front().value.limits; }
  const char* kind() const noexcept override { return protocol_->kind(); }
  bool served() const noexcept override { return true; }
  void serve(const std::atomic<bool>& stop) noexcept override;
  DeviceStatus status() const noexcept override { return {stage_.load(), problem_.load()}; }
  bool mayReturn() const noexcept override { return true; }

  /// One turn of `serve` without waiting, for virtual time. Service thread.
  void serviceOnce() noexcept;
  /// Zero force, then close. Service thread, or when no other thread is there.
  void close() noexcept;
  const UsbBinding& binding() const noexcept { return binding_; }  // service thread; the serial of the device in use
  const UsbCounters& counters() const noexcept { return counters_; }  // service thread

 private:
  struct Measured { UsbMeasurement value; std::uint64_t count = 0; };
  struct Wanted { Vec3 force = Vec3::Zero(); std::uint64_t count = 0; };   // [N]

  void received(std::span<const std::uint8_t>) noexcept override;
  void failed(UsbStatus) noexcept override;
  void search();
  void start(const UsbDeviceInfo&);
  void watch() noexcept;
  void exchange() noexcept;
  void drop(DeviceProblem) noexcept;
  void enter(DeviceStage, DeviceProblem) noexcept;

  std::shared_ptr<UsbBus> bus_;
  std::unique_ptr<UsbProtocol> protocol_;
  UsbBinding binding_;
  std::unique_ptr<UsbLink> link_;
  TripleBuffer<Measured> measured_;                               // service -> haptic
  TripleBuffer<Wanted> wanted_;                                   // haptic -> service
  std::atomic<DeviceStage> stage_{DeviceStage::kSearching};
  std::atomic<DeviceProblem> problem_{DeviceProblem::kNotAttached};
  std::atomic<bool> failing_{false};                              // service -> haptic: from a failed transfer to the next reading

  // Haptic thread's own.
  std::uint64_t seen_ = 0, writes_ = 0;
  double silence_ = 0.0;                                          // [s] since the last new reading
  double jaw_ = 1.0;                                              // [1]

  // Service thread's own.
  UsbMeasurement latest_;
  UsbCounters counters_;
  double nextSearch_ = 0.0, lastReading_ = 0.0, lastSend_ = 0.0, lastWanted_ = 0.0;   // [s] bus time
  std::uint64_t plugsSeen_ = ~0ull;
  int failuresInARow_ = 0;
  bool gone_ = false, halted_ = false, streaming_ = false;
};

}  // namespace halsted::haptics
