#include "haptics/usb/loopback_bus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace halsted::haptics {
namespace {

constexpr double kSlice = 50e-6;               // [s] of bus time
constexpr std::size_t kPacket = 512;           // longest IN transfer

}  // namespace

/// Its methods act on the port only while it is attached; an unplugged port fails everything with kGone.
class LoopbackLink final : public UsbLink {
 public:
  LoopbackLink(LoopbackBus& bus, LoopbackBus::Port& port) : bus_(bus), port_(port) { port_.link = this; }
  ~LoopbackLink() override { port_.link = nullptr; }

  UsbStatus control(const UsbControl& request, std::span<std::uint8_t> data, double timeout) override {  // [s]
    if (const UsbStatus blocked = becomeReady(timeout); blocked != UsbStatus::kOk) return blocked;
    return port_.model->control(request, data);
  }
  UsbStatus write(std::uint8_t endpoint, std::span<const std::uint8_t> bytes, double timeout) override {  // [s]
    if (const UsbStatus blocked = becomeReady(timeout); blocked != UsbStatus::kOk) return blocked;
    port_.model->out(endpoint, bytes);
    return UsbStatus::kOk;
  }
  UsbStatus read(std::uint8_t endpoint, std::span<std::uint8_t> bytes, std::size_t& got, double timeout) override {  // [s]
    const double until = bus_.now() + timeout;  // [s]
    for (;;) {
      if (!port_.attached) return UsbStatus::kGone;
      const UsbStatus status = transferIn(endpoint, bytes, got);
      if (status != UsbStatus::kTimeout) return status;
      if (bus_.now() >= until) return UsbStatus::kTimeout;
      bus_.advance(kSlice);
    }
  }
  UsbStatus startStream(std::uint8_t in, std::uint8_t out, UsbStreamOwner& owner) override {
    in_ = in;
    out_ = out;
    owner_ = &owner;
    return port_.attached ? UsbStatus::kOk : UsbStatus::kGone;
  }
  bool send(std::span<const std::uint8_t> bytes) noexcept override {
    if (!owner_ || pending_ > 0 || bytes.size() > waiting_.size()) return false;
    std::copy(bytes.begin(), bytes.end(), waiting_.begin());
    pending_ = bytes.size();
    return true;
  }
  void clearHalt(std::uint8_t) noexcept override {}
  void stopStream() noexcept override {
    owner_ = nullptr;
    pending_ = 0;
  }

  void advance() noexcept {
    if (!owner_) return;
    if (!port_.attached) return fail(UsbStatus::kGone);
    if (port_.faults.silentFor > 0.0) return;
    if (pending_ > 0) port_.model->out(out_, std::span<const std::uint8_t>(waiting_.data(), std::exchange(pending_, 0)));
    std::array<std::uint8_t, kPacket> bytes;
    std::size_t got = 0;
    const UsbStatus status = transferIn(in_, bytes, got);
    if (status == UsbStatus::kOk) owner_->received({bytes.data(), got});
    else if (status != UsbStatus::kTimeout) owner_->failed(status);
  }

 private:
  void fail(UsbStatus status) noexcept {
    UsbStreamOwner* owner = owner_;
    stopStream();                              // a stream that lost its device says so once
    owner->failed(status);
  }
  UsbStatus becomeReady(double timeout) {      // [s]
    const double until = bus_.now() + timeout;  // [s]
    bus_.advance(kSlice);
    while (port_.attached && port_.faults.silentFor > 0.0) {
      if (bus_.now() >= until) return UsbStatus::kTimeout;
      bus_.advance(kSlice);
    }
    return port_.attached ? UsbStatus::kOk : UsbStatus::kGone;
  }
  /// kTimeout: nothing to send just now.
  UsbStatus transferIn(std::uint8_t endpoint, std::span<std::uint8_t> bytes, std::size_t& got) {
    UsbFaults& faults = port_.faults;
    got = faults.silentFor > 0.0 ? 0 : port_.model->in(endpoint, bytes);
    if (got == 0) return UsbStatus::kTimeout;
    if (faults.failedTransfers > 0) {
      --faults.failedTransfers;
      return faults.failure;
    }
    if (got > 2 && faults.shortPackets > 0) {
      --faults.shortPackets;
      got /= 2;
    } else if (got > 2 && faults.corruptPackets > 0) {
      --faults.corruptPackets;
      bytes[2 + faults.where++ % (got - 2)] ^= 0x10;
    }
    return UsbStatus::kOk;
  }

  LoopbackBus& bus_;
  LoopbackBus::Port& port_;
  UsbStreamOwner* owner_ = nullptr;
  std::uint8_t in_ = 0, out_ = 0;
  std::array<std::uint8_t, 64> waiting_{};
  std::size_t pending_ = 0;
};

int LoopbackBus::plug(UsbModel& model) {
  ports_.push_back({&model, {}, nullptr, false});
  replug(static_cast<int>(ports_.size()) - 1);
  return static_cast<int>(ports_.size()) - 1;
}

void LoopbackBus::unplug(int port) {
  ports_[port].attached = false;
  ports_[port].model->detach();
  ++plugEvents_;
}

void LoopbackBus::replug(int port) {
  ports_[port].attached = true;
  ports_[port].model->attach();
  ++plugEvents_;
}

UsbFaults& LoopbackBus::faults(int port) { return ports_[port].faults; }

std::vector<UsbDeviceInfo> LoopbackBus::list() {
  std::vector<UsbDeviceInfo> found;
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    if (!ports_[i].attached) continue;
    UsbDeviceInfo info = ports_[i].model->info();
    info.bus = 1;
    info.address = static_cast<std::uint8_t>(i + 2);
    info.port = "1-" + std::to_string(i + 1);
    found.push_back(info);
  }
  return found;
}

std::unique_ptr<UsbLink> LoopbackBus::open(const UsbDeviceInfo& info, int, UsbStatus& status) {
  const int index = info.address - 2;
  status = UsbStatus::kNotFound;
  if (index < 0 || index >= static_cast<int>(ports_.size()) || !ports_[index].attached) return nullptr;
  Port& port = ports_[index];
  status = port.faults.refuseOpen != UsbStatus::kOk ? port.faults.refuseOpen : port.link ? UsbStatus::kBusy : UsbStatus::kOk;
  return status == UsbStatus::kOk ? std::make_unique<LoopbackLink>(*this, port) : nullptr;
}

void LoopbackBus::advance(double dt) noexcept {  // [s]
  const int slices = static_cast<int>(std::ceil(dt / kSlice - 1e-9));
  for (int i = 0; i < slices; ++i) advanceOnce(dt / slices);
}

void LoopbackBus::advanceOnce(double dt) noexcept {  // [s]
  time_ += dt;
  for (Port& port : ports_) {
    port.model->advance(dt);
    port.faults.silentFor = std::max(0.0, port.faults.silentFor - dt);
  }
  for (Port& port : ports_)
    if (port.link) port.link->advance();
}

}  // namespace halsted::haptics
