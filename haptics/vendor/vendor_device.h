#pragma once
/// A device of the vendor's, driven through the vendor's own library. That library has its own servo thread; the haptic tick and it
/// hand readings and forces over through carriers, so neither waits for the other. Opened and closed on the main thread; a lost device
/// is closed and opened again on the thread that serves it, and is known by its serial number.
#include <atomic>
#include <memory>
#include <string>

#include "haptics/carriers/triple_buffer.h"
#include "haptics/device.h"
#include "haptics/vendor/hd_library.h"

namespace halsted::haptics {

class VendorDevice final : public Device {
 public:
  struct Opened {
    std::unique_ptr<VendorDevice> device;      // null with the reason beside it
    DeviceProblem problem = DeviceProblem::kNone;
  };
  /// `name` as in the vendor's set-up program; empty: its default device.
  static Opened open(const std::string& name);
  ~VendorDevice() override;
  VendorDevice(const VendorDevice&) = delete;
  VendorDevice& operator=(const VendorDevice&) = delete;

  DeviceReading read(double dt) noexcept override;                // [s]
  bool write(const Vec3& force) noexcept override;                // [N]
  DeviceLimits limits() const noexcept override { return limits_; }
  const char* kind() const noexcept override { return "vendor"; }
  DeviceStatus status() const noexcept override { return {stage_.load(), problem_.load()}; }
  bool served() const noexcept override { return true; }
  void serve(const std::atomic<bool>& stop) noexcept override;
  bool mayReturn() const noexcept override { return true; }

  const std::string& model() const noexcept { return model_; }
  const std::string& serial() const noexcept { return serial_; }
  const std::string& library() const noexcept { return library_->path(); }
  std::uint64_t servoTicks() const noexcept { return servoTicks_.load(); }

 private:
  struct Measured { Pose pose; int buttons = 0; std::uint64_t count = 0; };
  struct Wanted { Vec3 force = Vec3::Zero(); std::uint64_t count = 0; };   // [N]

  VendorDevice(std::shared_ptr<HdLibrary> library, const std::string& name) : library_(std::move(library)), name_(name) {}
  bool attach();
  int detach();                                // how many it closed
  bool isTheSame() const;
  void identify();
  static unsigned int onServo(void* device);
  void servo() noexcept;
  void checkErrors() noexcept;

  std::shared_ptr<HdLibrary> library_;
  std::string name_;
  unsigned int handle_ = 0;
  unsigned long callback_ = 0;
  bool opened_ = false, known_ = false;
  unsigned int calibrationStyle_ = 4;          // the interface's mask: by the inkwell
  DeviceLimits limits_;
  std::string model_, serial_;
  TripleBuffer<Measured> measured_;            // servo -> haptic
  TripleBuffer<Wanted> wanted_;                // haptic -> servo
  std::atomic<DeviceStage> stage_{DeviceStage::kStarting};
  std::atomic<DeviceProblem> problem_{DeviceProblem::kNone};
  std::atomic<bool> broken_{false};            // servo -> haptic: the library reported a fault of the device
  std::atomic<std::uint64_t> servoTicks_{0};
  // Haptic thread's own.
  std::uint64_t seen_ = 0, writes_ = 0;
  double silence_ = 0.0, jaw_ = 1.0;           // [s] [1]
  int buttonsBefore_ = 0;
  std::uint32_t presses_ = 0;
  // Servo thread's own.
  std::uint64_t wantedSeen_ = 0;
  int wantedAge_ = 0;                          // servo ticks since the last force
};

}  // namespace halsted::haptics
