#include "haptics/vendor/vendor_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/realtime.h"

namespace halsted::haptics {
namespace {

// Values of the documented interface.
enum : unsigned int {
  kHdCurrentButtons = 0x2000, kHdCurrentTransform = 0x2052, kHdModel = 0x2501, kHdSerial = 0x2504, kHdCalibrationStyle = 0x2555,
  kHdNominalStiffness = 0x2602, kHdNominalForce = 0x2603, kHdNominalContinuous = 0x2604, kHdCurrentForce = 0x2700, kHdForceOutput = 0x4000,
  kHdCalibrationOk = 0x5000, kHdCalibrationNeedsUpdate = 0x5001, kHdCallbackContinue = 1
};
constexpr unsigned int kHdEncoderReset = 1, kHdAuto = 2, kHdInkwell = 4;
constexpr unsigned short kHdDefaultPriority = 32767;
constexpr double kSilent = 10e-3;              // [s] without a servo tick of the vendor's
constexpr int kForgetForce = 10;               // servo ticks without a new force: the haptic thread has stopped
constexpr double kJawRate = 7.0;               // [1/s]
constexpr int kButton1 = 1;
constexpr Nanoseconds kLookEvery = 20'000'000, kTryEvery = 500'000'000;  // [ns] for a lost device

/// Column-major 4x4 in millimetres.
Pose poseOf(const double* t) noexcept {
  Mat3 rotation;
  rotation << t[0], t[4], t[8], t[1], t[5], t[9], t[2], t[6], t[10];
  Pose pose;
  pose.position = Vec3(t[12], t[13], t[14]) * 1e-3;
  pose.orientation = Quat(rotation);
  return pose;
}

}  // namespace

VendorDevice::Opened VendorDevice::open(const std::string& name) {
  HdLoad loaded = HdLoad::kLoaded;
  auto library = HdLibrary::load(loaded);
  if (!library) return {nullptr, loaded == HdLoad::kMissing ? DeviceProblem::kVendorLibraryMissing : DeviceProblem::kVendorLibraryUnusable};
  std::unique_ptr<VendorDevice> device(new VendorDevice(library, name));
  library->whileStopped([&] { return device->attach() ? 1 : 0; });
  if (!device->opened_) return {nullptr, DeviceProblem::kVendorDeviceRefused};
  return {std::move(device), DeviceProblem::kNone};
}

VendorDevice::~VendorDevice() {
  if (opened_) library_->whileStopped([this] { return -detach(); });
}

/// The scheduler stands. The first time the device says what it is; later it must be the same one.
bool VendorDevice::attach() {
  const HdFunctions& hd = library_->call();
  library_->forgetErrors();                                      // what an earlier device left
  handle_ = hd.initDevice(name_.empty() ? nullptr : name_.c_str());
  if (hd.lastError().code != kHdSuccess || handle_ == kHdInvalidHandle) return false;
  if (known_ && !isTheSame()) {
    hd.disableDevice(handle_);
    problem_.store(DeviceProblem::kNotAttached, std::memory_order_relaxed);
    return false;
  }
  if (!known_) identify();
  known_ = opened_ = true;
  hd.enable(kHdForceOutput);
  library_->opened(handle_);
  wantedAge_ = kForgetForce;                                     // what was wanted before it left is not what is wanted now
  stage_.store(DeviceStage::kStarting, std::memory_order_relaxed);
  problem_.store(DeviceProblem::kNone, std::memory_order_relaxed);
  broken_.store(false, std::memory_order_release);
  callback_ = hd.scheduleAsynchronous(onServo, this, kHdDefaultPriority);
  return true;
}

int VendorDevice::detach() {
  if (!std::exchange(opened_, false)) return 0;
  library_->call().unschedule(callback_);
  library_->call().disableDevice(handle_);
  return 1;
}

bool VendorDevice::isTheSame() const {
  const char* serial = library_->call().readString(kHdSerial);
  return serial_.empty() || !serial || serial_ == serial;
}

/// Closes what is lost and tries to open it again, twice a second. Other devices of the library stand still for that moment; the session
/// waits anyway.
void VendorDevice::serve(const std::atomic<bool>& stop) noexcept {
  Nanoseconds next = monotonicNow(), nextTry = 0;
  while (!stop.load(std::memory_order_relaxed)) {
    sleepUntil(next += kLookEvery);
    if (!broken_.load(std::memory_order_acquire) || next < nextTry) continue;
    nextTry = next + kTryEvery;
    library_->whileStopped([this] {
      const int before = detach();
      return (attach() ? 1 : 0) - before;
    });
  }
}

void VendorDevice::identify() {
  const HdFunctions& hd = library_->call();
  const auto number = [&](unsigned int parameter, double otherwise) {
    double value = 0.0;
    hd.readDoubles(parameter, &value);
    return value > 0.0 && std::isfinite(value) ? value : otherwise;
  };
  limits_.peakForce = number(kHdNominalForce, limits_.peakForce);
  limits_.continuousForce = std::min(limits_.peakForce, number(kHdNominalContinuous, limits_.continuousForce));
  limits_.stiffness = number(kHdNominalStiffness, limits_.stiffness * 1e-3) * 1e3;   // N/mm
  const char* text = hd.readString(kHdModel);
  model_ = text ? text : "";
  int styles = 0;
  hd.readIntegers(kHdCalibrationStyle, &styles);
  for (const unsigned int style : {kHdEncoderReset, kHdInkwell, kHdAuto})       // the last one that it knows
    if (static_cast<unsigned int>(styles) & style) calibrationStyle_ = style;
  text = hd.readString(kHdSerial);
  serial_ = text ? text : "";
  library_->forgetErrors();                                      // some libraries lack one of these
}

unsigned int VendorDevice::onServo(void* device) {
  static_cast<VendorDevice*>(device)->servo();
  return kHdCallbackContinue;
}

/// One tick of the vendor's servo thread.
void VendorDevice::servo() noexcept {
  const HdFunctions& hd = library_->call();
  hd.makeCurrentDevice(handle_);
  const unsigned int calibration = hd.checkCalibration();
  if (calibration == kHdCalibrationNeedsUpdate) hd.updateCalibration(calibrationStyle_);
  const bool calibrated = calibration == kHdCalibrationOk || calibration == kHdCalibrationNeedsUpdate;

  hd.beginFrame(handle_);
  double transform[16] = {};
  Measured& measured = measured_.back();
  hd.readDoubles(kHdCurrentTransform, transform);
  hd.readIntegers(kHdCurrentButtons, &measured.buttons);
  measured.pose = poseOf(transform);
  measured.count = servoTicks_.load(std::memory_order_relaxed) + 1;

  wanted_.acquire();
  const Wanted& wanted = wanted_.front();
  wantedAge_ = wanted.count != std::exchange(wantedSeen_, wanted.count) ? 0 : wantedAge_ + 1;
  const bool push = calibrated && wantedAge_ <= kForgetForce && !broken_.load(std::memory_order_relaxed);
  const double force[3] = {push ? wanted.force.x() : 0.0, push ? wanted.force.y() : 0.0, push ? wanted.force.z() : 0.0};
  hd.setDoubles(kHdCurrentForce, force);
  hd.endFrame(handle_);
  checkErrors();

  measured_.publish();
  servoTicks_.fetch_add(1, std::memory_order_relaxed);
  if (broken_.load(std::memory_order_relaxed)) return;
  problem_.store(calibrated ? DeviceProblem::kNone : DeviceProblem::kNeedsInkwell, std::memory_order_relaxed);
  stage_.store(calibrated ? DeviceStage::kReady : DeviceStage::kHoming, std::memory_order_release);
}

void VendorDevice::checkErrors() noexcept {
  if (!library_->isLost(handle_)) return;
  problem_.store(DeviceProblem::kTransferFailed, std::memory_order_relaxed);
  stage_.store(DeviceStage::kSearching, std::memory_order_release);
  broken_.store(true, std::memory_order_release);
}

DeviceReading VendorDevice::read(double dt) noexcept {  // [s]
  measured_.acquire();
  const Measured& measured = measured_.front();
  silence_ = measured.count != std::exchange(seen_, measured.count) ? 0.0 : silence_ + dt;
  jaw_ += std::clamp((measured.buttons & kButton1 ? 0.0 : 1.0) - jaw_, -kJawRate * dt, kJawRate * dt);
  presses_ += (measured.buttons & ~buttonsBefore_ & ~kButton1) != 0;
  buttonsBefore_ = measured.buttons;
  DeviceReading reading{measured.pose, jaw_, presses_};
  const DeviceStage stage = stage_.load(std::memory_order_acquire);
  reading.connected = !broken_.load(std::memory_order_acquire) && stage != DeviceStage::kSearching;
  reading.fresh = silence_ <= kSilent && stage == DeviceStage::kReady;
  return reading;
}

bool VendorDevice::write(const Vec3& force) noexcept {
  wanted_.back() = {force, ++writes_};
  wanted_.publish();
  return !broken_.load(std::memory_order_acquire);
}

}  // namespace halsted::haptics
