#include "haptics/usb/usb_device.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halsted::haptics {
namespace {

constexpr double kSilent = 10e-3;              // [s] without a reading: the transport is silent, force is zero
constexpr double kDead = 0.25;                 // [s] without a reading: close and begin again
constexpr double kRepeat = 3e-3;               // [s] without an answer: ask again
constexpr double kShortestTurn = 0.2e-3;       // [s] between two commands: an answer that was only late must not double the traffic for ever
constexpr double kSearchEvery = 0.5;           // [s]
constexpr double kWriteTimeout = 50e-3;        // [s]
constexpr double kJawRate = 7.0;               // [1/s] a button closes the jaws in 0.14 s
constexpr int kFailuresToReopen = 8;

DeviceProblem problemOf(UsbStatus status) {
  switch (status) {
    case UsbStatus::kOk: return DeviceProblem::kNone;
    case UsbStatus::kNoPermission: return DeviceProblem::kNoPermission;
    case UsbStatus::kBusy: return DeviceProblem::kBusy;
    case UsbStatus::kGone: return DeviceProblem::kUnplugged;
    case UsbStatus::kNotFound: return DeviceProblem::kNotAttached;
    case UsbStatus::kTimeout: return DeviceProblem::kNotAnswering;
    default: return DeviceProblem::kTransferFailed;
  }
}

}  // namespace

UsbDevice::UsbDevice(std::shared_ptr<UsbBus> bus, std::unique_ptr<UsbProtocol> protocol, UsbBinding binding)
    : bus_(std::move(bus)), protocol_(std::move(protocol)), binding_(std::move(binding)) {
  latest_.limits = protocol_->limits();
  measured_.back().value.limits = latest_.limits;
  measured_.publish();
  measured_.acquire();
}

UsbDevice::~UsbDevice() { close(); }

DeviceReading UsbDevice::read(double dt) noexcept {  // [s]
  measured_.acquire();
  const Measured& measured = measured_.front();
  silence_ = measured.count != seen_ ? 0.0 : silence_ + dt;
  seen_ = measured.count;
  jaw_ += std::clamp(std::clamp(measured.value.jaw, 0.0, 1.0) - jaw_, -kJawRate * dt, kJawRate * dt);
  DeviceReading reading{measured.value.pose, jaw_, measured.value.presses};
  reading.connected = stage_.load(std::memory_order_acquire) == DeviceStage::kReady;
  reading.fresh = silence_ <= kSilent && !failing_.load(std::memory_order_acquire);
  return reading;
}

bool UsbDevice::write(const Vec3& force) noexcept {
  wanted_.back() = {force, ++writes_};
  wanted_.publish();
  return stage_.load(std::memory_order_acquire) == DeviceStage::kReady;
}

void UsbDevice::serve(const std::atomic<bool>& stop) noexcept {
  while (!stop.load(std::memory_order_relaxed)) {
    serviceOnce();
    bus_->wait(link_ ? 1e-3 : 20e-3);
  }
  close();
}

void UsbDevice::serviceOnce() noexcept {
  if (!link_) {
    const std::uint64_t plugs = bus_->plugEvents();
    if (plugs == plugsSeen_ && bus_->now() < nextSearch_) return;
    plugsSeen_ = plugs;
    nextSearch_ = bus_->now() + kSearchEvery;
    try {
      search();
    } catch (const std::exception&) {          // only the heap throws here
      drop(DeviceProblem::kMemoryShort);
    }
    return;
  }
  watch();
}

void UsbDevice::search() {
  const DeviceProblem missing = counters_.opened > 0 ? DeviceProblem::kUnplugged : DeviceProblem::kNotAttached;
  DeviceProblem found = missing;
  for (const UsbDeviceInfo& info : bus_->list()) {
    if (!protocol_->matches(info)) continue;
    if (!binding_.serial.empty() ? info.serial != binding_.serial : !binding_.port.empty() && info.port != binding_.port) continue;
    start(info);
    if (link_) return;
    found = problem_.load();
  }
  enter(DeviceStage::kSearching, found);
}

void UsbDevice::start(const UsbDeviceInfo& info) {
  UsbStatus status = UsbStatus::kOk;
  link_ = bus_->open(info, protocol_->pipes().interfaces, status);
  if (!link_) return enter(DeviceStage::kSearching, problemOf(status));
  enter(DeviceStage::kStarting, DeviceProblem::kNone);
  const DeviceProblem problem = protocol_->bringUp(*link_);
  if (problem != DeviceProblem::kNone) return drop(problem);
  const UsbPipes pipes = protocol_->pipes();
  status = link_->startStream(pipes.in, pipes.out, *this);
  if (status != UsbStatus::kOk) return drop(problemOf(status));
  streaming_ = true;
  // From here this is our device: after a replug only the same one will do.
  if (!info.serial.empty()) binding_.serial = info.serial;
  else binding_.port = info.port;
  ++counters_.opened;
  gone_ = halted_ = false;
  failuresInARow_ = 0;
  lastReading_ = bus_->now();
  enter(DeviceStage::kHoming, protocol_->notCalibrated());
  exchange();
}

void UsbDevice::watch() noexcept {
  const double now = bus_->now();              // [s]
  if (gone_) return drop(DeviceProblem::kUnplugged);
  if (failuresInARow_ >= kFailuresToReopen) return drop(DeviceProblem::kTransferFailed);
  if (now - lastReading_ > kDead) return drop(DeviceProblem::kNotAnswering);
  if (std::exchange(halted_, false)) link_->clearHalt(protocol_->pipes().in);
  if (now - std::max(lastReading_, lastSend_) > kRepeat) {
    ++counters_.repeated;
    exchange();
  }
}

void UsbDevice::received(std::span<const std::uint8_t> packet) noexcept {
  const PacketOutcome outcome = protocol_->received(packet, latest_);
  counters_.corrupt += static_cast<std::uint64_t>(outcome.broken);
  if (!outcome.reading) {
    if (outcome.broken > 0) exchange();        // what was lost is asked for again at once
    return;
  }
  failuresInARow_ = 0;
  lastReading_ = bus_->now();
  measured_.back() = {latest_, ++counters_.readings};
  measured_.publish();
  failing_.store(false, std::memory_order_release);
  if (latest_.calibrated) enter(DeviceStage::kReady, DeviceProblem::kNone);
  else enter(DeviceStage::kHoming, protocol_->notCalibrated());
  exchange();
}

void UsbDevice::failed(UsbStatus status) noexcept {
  failing_.store(true, std::memory_order_release);
  ++counters_.failed;
  ++failuresInARow_;
  gone_ = gone_ || status == UsbStatus::kGone;
  halted_ = halted_ || status == UsbStatus::kStalled;
  if (gone_) enter(DeviceStage::kSearching, DeviceProblem::kUnplugged);
}

/// Sends the newest force, or none where none is safe.
void UsbDevice::exchange() noexcept {
  const double now = bus_->now();              // [s]
  if (wanted_.acquire()) lastWanted_ = now;
  if (now - lastSend_ < kShortestTurn) return;
  const bool enabled = stage_.load(std::memory_order_relaxed) == DeviceStage::kReady && !failing_.load(std::memory_order_relaxed) &&
                       now - lastReading_ <= kSilent && now - lastWanted_ <= kSilent;
  std::array<std::uint8_t, 64> packet;
  const std::size_t size = protocol_->command(enabled ? wanted_.front().force : Vec3(Vec3::Zero()), enabled, packet);
  lastSend_ = now;
  if (link_) link_->send({packet.data(), size});
}

void UsbDevice::drop(DeviceProblem problem) noexcept {
  close();
  nextSearch_ = bus_->now() + kSearchEvery;
  enter(DeviceStage::kSearching, problem);
}

void UsbDevice::close() noexcept {
  if (!link_) return;
  link_->stopStream();
  if (std::exchange(streaming_, false) && !gone_) {
    std::array<std::uint8_t, 64> packet;
    const std::size_t size = protocol_->command(Vec3::Zero(), false, packet);
    link_->write(protocol_->pipes().out, {packet.data(), size}, kWriteTimeout);
  }
  link_.reset();
}

void UsbDevice::enter(DeviceStage stage, DeviceProblem problem) noexcept {
  problem_.store(problem, std::memory_order_relaxed);
  stage_.store(stage, std::memory_order_release);
}

}  // namespace halsted::haptics
