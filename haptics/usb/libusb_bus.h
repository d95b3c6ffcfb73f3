#pragma once
/// The real bus. One libusb context, used by one thread: transfers are asynchronous and complete inside `wait`, plug events too.
/// libusb takes memory and locks when it submits; it does so on this thread, never on the haptic one.
#include "haptics/usb/usb.h"

struct libusb_context;
struct libusb_device;

namespace halsted::haptics {

class LibusbBus final : public UsbBus {
 public:
  LibusbBus();
  ~LibusbBus() override;
  LibusbBus(const LibusbBus&) = delete;
  LibusbBus& operator=(const LibusbBus&) = delete;

  bool available() const noexcept { return context_ != nullptr; }  // false: this system has no USB
  std::vector<UsbDeviceInfo> list() override;
  std::unique_ptr<UsbLink> open(const UsbDeviceInfo&, int interfaces, UsbStatus&) override;
  void wait(double longest) noexcept override;                     // [s]
  std::uint64_t plugEvents() const noexcept override { return plugEvents_; }
  double now() const noexcept override;

  void countPlugEvent() noexcept { ++plugEvents_; }                // for libusb's callback, inside `wait`

 private:
  libusb_context* context_ = nullptr;
  int hotplug_ = -1;                           // handle of the callback; -1: no plug events here, only the periodic search
  std::uint64_t plugEvents_ = 0;
};

}  // namespace halsted::haptics
