#pragma once
/// A USB device in software: what sits behind the loopback bus, and in tests behind the real libusb. Single thread, virtual time.
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/usb/usb.h"

namespace halsted::haptics {

class UsbModel {
 public:
  virtual ~UsbModel() = default;
  virtual UsbDeviceInfo info() const = 0;
  virtual std::vector<std::uint8_t> descriptors() const = 0;       // device and configuration, as on the wire
  virtual void attach() = 0;                                       // power and bus reset: what a plug does
  virtual void detach() {}                                         // the cable is out; what has its own supply goes on
  virtual UsbStatus control(const UsbControl&, std::span<std::uint8_t> data) = 0;
  virtual void out(std::uint8_t endpoint, std::span<const std::uint8_t>) = 0;
  /// Bytes that the endpoint has to send now, 0 when it has none. A packet of no bytes is not modelled.
  virtual std::size_t in(std::uint8_t endpoint, std::span<std::uint8_t>) = 0;
  virtual void advance(double dt) = 0;                             // [s]
};

/// Descriptors of a one-interface device with a bulk pair, as most of these have.
struct BulkPair { std::uint16_t vendor, product, version; std::uint8_t interfaceClass, in, out; bool hasSerial; };
std::vector<std::uint8_t> bulkDescriptors(const BulkPair&);

}  // namespace halsted::haptics
