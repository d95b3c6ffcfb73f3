#pragma once
/// A 3D Systems Touch over its serial USB interface: what it says about itself. Its servo stream is not public, so nothing here moves it
/// or reads where it is. Frames as one public project reported them: A5 5A, command, length, payload.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/usb/usb.h"

namespace halsted::haptics {

enum TouchCommand : std::uint8_t { kTouchAskFirmware = 0x0f, kTouchFirmware = 0x0e, kTouchAskSerial = 0x0c, kTouchSerial = 0x09 };

struct TouchFrame { std::uint8_t command = 0; std::vector<std::uint8_t> payload; };
std::vector<std::uint8_t> encode(const TouchFrame&);

/// Cuts frames out of the stream; bytes before A5 5A are dropped. At most 255 bytes of payload by the format.
class TouchFramer {
 public:
  std::optional<TouchFrame> push(std::uint8_t byte);

 private:
  std::vector<std::uint8_t> bytes_;
};

/// The printable part of a reply: devices pad with zeros and other bytes.
std::string printableText(std::span<const std::uint8_t>);

struct TouchIdentity { std::string firmware, serial; };          // empty: it did not answer that question
/// Blocking, about half a second at most. kTimeout when it answers nothing at all.
UsbStatus identifyTouch(UsbLink&, TouchIdentity&);

inline constexpr int kTouchInterfaces = 2;                       // CDC: line settings, and the bytes
inline constexpr std::uint8_t kTouchIn = 0x81, kTouchOut = 0x02;

}  // namespace halsted::haptics
