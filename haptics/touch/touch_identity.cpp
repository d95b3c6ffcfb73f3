#include "haptics/touch/touch_identity.h"

#include <algorithm>
#include <array>

namespace halsted::haptics {
namespace {

constexpr std::uint8_t kMark0 = 0xa5, kMark1 = 0x5a;
constexpr std::size_t kHeader = 4;
constexpr double kAnswer = 0.1;                // [s] for one transfer
constexpr int kTransfers = 4;                  // that may pass before the answer is whole

/// CDC: 115200 baud, 8N1, as a terminal would set it.
UsbStatus setLine(UsbLink& link) {
  std::array<std::uint8_t, 7> line{0x00, 0xc2, 0x01, 0x00, 0, 0, 8};
  constexpr UsbControl kSetLineCoding{0x21, 0x20, 0, 0}, kSetControlLines{0x21, 0x22, 3, 0};
  const UsbStatus status = link.control(kSetLineCoding, line, kAnswer);
  return status == UsbStatus::kOk ? link.control(kSetControlLines, {}, kAnswer) : status;
}

/// Sends `question`, waits for a frame of `answer`; others are passed over.
std::optional<TouchFrame> ask(UsbLink& link, const TouchFrame& question, std::uint8_t answer) {
  if (link.write(kTouchOut, encode(question), kAnswer) != UsbStatus::kOk) return std::nullopt;
  TouchFramer framer;
  for (int i = 0; i < kTransfers; ++i) {
    std::array<std::uint8_t, 64> packet;
    std::size_t got = 0;
    if (link.read(kTouchIn, packet, got, kAnswer) != UsbStatus::kOk) return std::nullopt;
    for (std::size_t k = 0; k < got; ++k)
      if (auto frame = framer.push(packet[k]); frame && frame->command == answer) return frame;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::uint8_t> encode(const TouchFrame& frame) {
  const std::size_t length = std::min<std::size_t>(frame.payload.size(), 255);
  std::vector<std::uint8_t> bytes{kMark0, kMark1, frame.command, static_cast<std::uint8_t>(length)};
  bytes.insert(bytes.end(), frame.payload.begin(), frame.payload.begin() + static_cast<std::ptrdiff_t>(length));
  return bytes;
}

std::optional<TouchFrame> TouchFramer::push(std::uint8_t byte) {
  if (bytes_.empty() && byte != kMark0) return std::nullopt;
  if (bytes_.size() == 1 && byte != kMark1) {
    bytes_.clear();
    if (byte == kMark0) bytes_.push_back(byte);
    return std::nullopt;
  }
  bytes_.push_back(byte);
  if (bytes_.size() < kHeader || bytes_.size() < kHeader + bytes_[3]) return std::nullopt;
  TouchFrame frame{bytes_[2], {bytes_.begin() + kHeader, bytes_.end()}};
  bytes_.clear();
  return frame;
}

std::string printableText(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes)
    if (byte >= 0x20 && byte < 0x7f) text += static_cast<char>(byte);
    else if (!text.empty() && text.back() != ' ') text += ' ';
  while (!text.empty() && text.back() == ' ') text.pop_back();
  text.erase(0, text.find_first_not_of(' '));
  return text;
}

UsbStatus identifyTouch(UsbLink& link, TouchIdentity& identity) {
  const UsbStatus line = setLine(link);
  if (line != UsbStatus::kOk) return line;
  if (const auto answer = ask(link, {kTouchAskFirmware, std::vector<std::uint8_t>(32, 0)}, kTouchFirmware))
    identity.firmware = printableText(answer->payload);
  if (const auto answer = ask(link, {kTouchAskSerial, {0x00}}, kTouchSerial)) identity.serial = printableText(answer->payload);
  return identity.firmware.empty() && identity.serial.empty() ? UsbStatus::kTimeout : UsbStatus::kOk;
}

}  // namespace halsted::haptics
