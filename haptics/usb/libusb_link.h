#pragma once
/// A device opened through libusb. Two IN and two OUT transfers with their buffers are taken at the start of a stream and used again
/// and again. All calls and callbacks are on the bus's thread.
#include <array>

#include "haptics/usb/usb.h"

struct libusb_context;
struct libusb_device_handle;
struct libusb_transfer;

namespace halsted::haptics {

UsbStatus statusOfLibusb(int error) noexcept;

class LibusbLink final : public UsbLink {
 public:
  /// Takes over the open handle.
  LibusbLink(libusb_context*, libusb_device_handle*) noexcept;
  ~LibusbLink() override;
  LibusbLink(const LibusbLink&) = delete;
  LibusbLink& operator=(const LibusbLink&) = delete;

  UsbStatus claim(int interfaceNumber) noexcept;
  UsbStatus control(const UsbControl&, std::span<std::uint8_t> data, double timeout) override;       // [s]
  UsbStatus write(std::uint8_t endpoint, std::span<const std::uint8_t>, double timeout) override;     // [s]
  UsbStatus read(std::uint8_t endpoint, std::span<std::uint8_t>, std::size_t& got, double timeout) override;  // [s]
  UsbStatus startStream(std::uint8_t in, std::uint8_t out, UsbStreamOwner&) override;
  bool send(std::span<const std::uint8_t>) noexcept override;
  void clearHalt(std::uint8_t endpoint) noexcept override;
  void stopStream() noexcept override;

  void completed(libusb_transfer&) noexcept;   // for libusb's callback

 private:
  struct Slot {
    libusb_transfer* transfer = nullptr;
    std::array<std::uint8_t, 512> buffer{};
    bool flying = false;
  };
  bool prepare(Slot&, std::uint8_t endpoint);
  void submit(Slot&) noexcept;
  void report(UsbStatus) noexcept;

  libusb_context* context_;
  libusb_device_handle* handle_;
  int claimed_ = 0;                            // interfaces 0 to claimed_ - 1
  UsbStreamOwner* owner_ = nullptr;
  std::array<Slot, 2> in_, out_;
  bool gone_ = false;
};

}  // namespace halsted::haptics
