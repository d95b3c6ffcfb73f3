#pragma once
/// USB as a driver sees it: list what is attached, open one device, move bytes. Two buses stand behind it: libusb (`libusb_bus.h`)
/// and a loopback that carries device models in virtual time (`loopback_bus.h`), so that a driver is one code for both.
/// One thread per bus, the device's service thread; never the haptic tick. Nothing here throws.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace halsted::haptics {

enum class UsbStatus : std::uint8_t {
  kOk, kTimeout,
  kStalled,                                    // the endpoint refused: clear it and go on
  kGone,                                       // unplugged
  kOverflow,                                   // more arrived than was asked for
  kNoPermission, kBusy, kNotFound, kFailed
};
const char* name(UsbStatus) noexcept;

/// One attached device. `serial` needs the device to be readable: empty when the system does not publish it.
struct UsbDeviceInfo {
  std::uint16_t vendor = 0, product = 0;
  std::uint8_t bus = 0, address = 0;
  std::string port;                            // where it is plugged in, like "1-2.3": stays when it is plugged in again
  std::string serial, productName;
};

struct UsbControl { std::uint8_t type = 0, request = 0; std::uint16_t value = 0, index = 0; };

/// What a stream tells its owner; called from within UsbBus::wait. `failed` comes once per failed transfer.
class UsbStreamOwner {
 public:
  virtual ~UsbStreamOwner() = default;
  virtual void received(std::span<const std::uint8_t> packet) noexcept = 0;
  virtual void failed(UsbStatus) noexcept = 0;
};

/// An opened device with its interfaces claimed. Closing releases it.
class UsbLink {
 public:
  virtual ~UsbLink() = default;
  /// Blocking, each within `timeout` [s]: for bringing a device up, never while a stream runs.
  virtual UsbStatus control(const UsbControl&, std::span<std::uint8_t> data, double timeout) = 0;   // direction: type & 0x80
  virtual UsbStatus write(std::uint8_t endpoint, std::span<const std::uint8_t>, double timeout) = 0;  // [s]
  virtual UsbStatus read(std::uint8_t endpoint, std::span<std::uint8_t>, std::size_t& got, double timeout) = 0;  // [s]

  /// Keeps two IN transfers pending for ever; what arrives and what fails goes to the owner. All memory is taken here.
  virtual UsbStatus startStream(std::uint8_t in, std::uint8_t out, UsbStreamOwner&) = 0;
  /// Queues one OUT packet of the stream, at most 64 bytes; false when the last two are still on their way or the stream is not running.
  virtual bool send(std::span<const std::uint8_t>) noexcept = 0;
  virtual void clearHalt(std::uint8_t endpoint) noexcept = 0;
  virtual void stopStream() noexcept = 0;
};

class UsbBus {
 public:
  virtual ~UsbBus() = default;
  virtual std::vector<UsbDeviceInfo> list() = 0;                   // in order of bus and port
  /// Claims interfaces 0 to `interfaces` - 1. Null with the reason in `status`.
  virtual std::unique_ptr<UsbLink> open(const UsbDeviceInfo&, int interfaces, UsbStatus& status) = 0;
  /// Lets transfers and plug events happen for at most this long [s]; returns earlier when something did.
  virtual void wait(double longest) noexcept = 0;
  virtual std::uint64_t plugEvents() const noexcept = 0;           // arrivals and departures so far
  virtual double now() const noexcept = 0;                         // [s] monotonic; virtual time in the loopback
};

}  // namespace halsted::haptics
