#include "haptics/usb/libusb_link.h"

#include <libusb.h>

#include <algorithm>
#include <utility>

namespace halsted::haptics {
namespace {

constexpr int kCancelTurns = 50;               // of 20 ms: how long a cancelled transfer is waited for

unsigned milliseconds(double seconds) { return std::max(1u, static_cast<unsigned>(seconds * 1e3 + 0.5)); }

void LIBUSB_CALL onCompletion(libusb_transfer* transfer) { static_cast<LibusbLink*>(transfer->user_data)->completed(*transfer); }

UsbStatus statusOfTransfer(libusb_transfer_status status) {
  switch (status) {
    case LIBUSB_TRANSFER_COMPLETED: return UsbStatus::kOk;
    case LIBUSB_TRANSFER_TIMED_OUT: return UsbStatus::kTimeout;
    case LIBUSB_TRANSFER_STALL: return UsbStatus::kStalled;
    case LIBUSB_TRANSFER_NO_DEVICE: return UsbStatus::kGone;
    case LIBUSB_TRANSFER_OVERFLOW: return UsbStatus::kOverflow;
    default: return UsbStatus::kFailed;
  }
}

}  // namespace

UsbStatus statusOfLibusb(int error) noexcept {
  switch (error) {
    case LIBUSB_SUCCESS: return UsbStatus::kOk;
    case LIBUSB_ERROR_ACCESS: return UsbStatus::kNoPermission;
    case LIBUSB_ERROR_BUSY: return UsbStatus::kBusy;
    case LIBUSB_ERROR_NO_DEVICE: return UsbStatus::kGone;
    case LIBUSB_ERROR_NOT_FOUND: return UsbStatus::kNotFound;
    case LIBUSB_ERROR_TIMEOUT: return UsbStatus::kTimeout;
    case LIBUSB_ERROR_PIPE: return UsbStatus::kStalled;
    case LIBUSB_ERROR_OVERFLOW: return UsbStatus::kOverflow;
    default: return error > 0 ? UsbStatus::kOk : UsbStatus::kFailed;
  }
}

LibusbLink::LibusbLink(libusb_context* context, libusb_device_handle* handle) noexcept : context_(context), handle_(handle) {}

LibusbLink::~LibusbLink() {
  stopStream();
  for (auto* slots : {&in_, &out_})
    for (Slot& slot : *slots) libusb_free_transfer(slot.transfer);
  for (int i = claimed_ - 1; i >= 0; --i) libusb_release_interface(handle_, i);
  libusb_close(handle_);
}

UsbStatus LibusbLink::claim(int interfaceNumber) noexcept {
  const UsbStatus status = statusOfLibusb(libusb_claim_interface(handle_, interfaceNumber));
  if (status == UsbStatus::kOk) claimed_ = interfaceNumber + 1;
  return status;
}

UsbStatus LibusbLink::control(const UsbControl& request, std::span<std::uint8_t> data, double timeout) {  // [s]
  return statusOfLibusb(libusb_control_transfer(handle_, request.type, request.request, request.value, request.index, data.data(),
                                                static_cast<std::uint16_t>(data.size()), milliseconds(timeout)));
}

UsbStatus LibusbLink::write(std::uint8_t endpoint, std::span<const std::uint8_t> bytes, double timeout) {  // [s]
  int sent = 0;
  const int error = libusb_bulk_transfer(handle_, endpoint, const_cast<std::uint8_t*>(bytes.data()), static_cast<int>(bytes.size()),
                                         &sent, milliseconds(timeout));
  if (error == LIBUSB_ERROR_PIPE) libusb_clear_halt(handle_, endpoint);
  if (error == 0 && sent != static_cast<int>(bytes.size())) return UsbStatus::kFailed;
  return statusOfLibusb(error);
}

UsbStatus LibusbLink::read(std::uint8_t endpoint, std::span<std::uint8_t> bytes, std::size_t& got, double timeout) {  // [s]
  int received = 0;
  const int error = libusb_bulk_transfer(handle_, endpoint, bytes.data(), static_cast<int>(bytes.size()), &received, milliseconds(timeout));
  got = static_cast<std::size_t>(std::max(0, received));
  if (error == LIBUSB_ERROR_PIPE) libusb_clear_halt(handle_, endpoint);
  return error == LIBUSB_ERROR_TIMEOUT && got > 0 ? UsbStatus::kOk : statusOfLibusb(error);
}

bool LibusbLink::prepare(Slot& slot, std::uint8_t endpoint) {
  if (!slot.transfer) slot.transfer = libusb_alloc_transfer(0);
  if (!slot.transfer) return false;
  libusb_fill_bulk_transfer(slot.transfer, handle_, endpoint, slot.buffer.data(), static_cast<int>(slot.buffer.size()), onCompletion, this, 0);
  return true;
}

UsbStatus LibusbLink::startStream(std::uint8_t in, std::uint8_t out, UsbStreamOwner& owner) {
  for (Slot& slot : in_)
    if (!prepare(slot, in)) return UsbStatus::kFailed;
  for (Slot& slot : out_)
    if (!prepare(slot, out)) return UsbStatus::kFailed;
  gone_ = false;
  owner_ = &owner;
  for (Slot& slot : in_) submit(slot);
  return gone_ ? UsbStatus::kGone : UsbStatus::kOk;
}

/// A transfer that cannot even be submitted is a failed one.
void LibusbLink::submit(Slot& slot) noexcept {
  const int error = libusb_submit_transfer(slot.transfer);
  slot.flying = error == 0;
  if (error != 0) report(statusOfLibusb(error));
}

void LibusbLink::report(UsbStatus status) noexcept {
  if (status == UsbStatus::kGone && std::exchange(gone_, true)) return;   // both transfers fail; it is said once
  if (owner_) owner_->failed(status);
}

bool LibusbLink::send(std::span<const std::uint8_t> bytes) noexcept {
  if (!owner_ || gone_) return false;
  for (Slot& slot : out_) {
    if (slot.flying || bytes.size() > slot.buffer.size()) continue;
    std::copy(bytes.begin(), bytes.end(), slot.buffer.begin());
    slot.transfer->length = static_cast<int>(bytes.size());
    submit(slot);
    return slot.flying;
  }
  return false;
}

void LibusbLink::completed(libusb_transfer& transfer) noexcept {
  const bool incoming = transfer.endpoint & LIBUSB_ENDPOINT_IN;
  for (Slot& slot : incoming ? in_ : out_) {
    if (slot.transfer != &transfer) continue;
    slot.flying = false;
    if (transfer.status == LIBUSB_TRANSFER_CANCELLED || !owner_) return;
    const UsbStatus status = statusOfTransfer(transfer.status);
    if (status != UsbStatus::kOk) report(status);
    else if (incoming && transfer.actual_length > 0) owner_->received({slot.buffer.data(), static_cast<std::size_t>(transfer.actual_length)});
    // A halted endpoint waits for clearHalt, a device that is gone for nothing any more.
    if (incoming && owner_ && !gone_ && status != UsbStatus::kStalled) submit(slot);
    return;
  }
}

void LibusbLink::clearHalt(std::uint8_t endpoint) noexcept {
  if (gone_) return;
  const int error = libusb_clear_halt(handle_, endpoint);
  if (error != 0) return report(statusOfLibusb(error));
  if (!owner_ || !(endpoint & LIBUSB_ENDPOINT_IN)) return;
  for (Slot& slot : in_)
    if (!slot.flying) submit(slot);
}

void LibusbLink::stopStream() noexcept {
  owner_ = nullptr;
  const auto flying = [this] {
    bool any = false;
    for (auto* slots : {&in_, &out_})
      for (Slot& slot : *slots) any = any || slot.flying;
    return any;
  };
  for (auto* slots : {&in_, &out_})
    for (Slot& slot : *slots)
      if (slot.flying) libusb_cancel_transfer(slot.transfer);
  timeval turn{0, 20'000};
  for (int i = 0; i < kCancelTurns && flying(); ++i) libusb_handle_events_timeout_completed(context_, &turn, nullptr);
}

}  // namespace halsted::haptics
