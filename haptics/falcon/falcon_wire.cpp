#include "haptics/falcon/falcon_wire.h"

#include <algorithm>
#include <utility>

namespace halsted::haptics {
namespace {

constexpr std::uint8_t kZero = 'A';

void putNumber(int value, std::uint8_t* at) noexcept {
  const unsigned bits = static_cast<unsigned>(value) & 0xffffu;
  for (int i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(kZero + (bits >> (4 * i) & 0xf));
}

std::optional<int> takeNumber(const std::uint8_t* at) noexcept {
  unsigned bits = 0;
  for (int i = 0; i < 4; ++i) {
    const unsigned nibble = static_cast<unsigned>(at[i]) - kZero;
    if (nibble > 0xf) return std::nullopt;
    bits |= nibble << (4 * i);
  }
  return static_cast<std::int16_t>(bits);
}

bool framed(std::span<const std::uint8_t> bytes) noexcept {
  return bytes.size() == kFalconFrame && bytes[0] == '<' && bytes[15] == '>';
}

bool takeNumbers(std::span<const std::uint8_t> bytes, std::array<int, 3>& numbers) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = takeNumber(&bytes[1 + 4 * i]);
    if (!number) return false;
    numbers[i] = *number;
  }
  return true;
}

FalconFrame frameOf(const std::array<int, 3>& numbers, std::uint8_t status) noexcept {
  FalconFrame frame;
  frame.fill(kZero);
  frame[0] = '<';
  for (std::size_t i = 0; i < 3; ++i) putNumber(numbers[i], &frame[1 + 4 * i]);
  frame[13] = static_cast<std::uint8_t>(kZero + status);
  frame[15] = '>';
  return frame;
}

}  // namespace

FalconFrame encode(const FalconCommand& command) noexcept {
  std::array<int, 3> motors;
  for (std::size_t i = 0; i < 3; ++i) motors[i] = std::clamp(command.motors[i], -kFalconMotorLimit, kFalconMotorLimit);
  return frameOf(motors, static_cast<std::uint8_t>((command.lights & 0xe) | (command.homing ? 1 : 0)));
}

FalconFrame encode(const FalconReply& reply) noexcept {
  return frameOf(reply.encoders, static_cast<std::uint8_t>((reply.buttons & 0xf) | (reply.homed & 7) << 4));
}

std::optional<FalconCommand> decodeFalconCommand(std::span<const std::uint8_t> bytes) noexcept {
  FalconCommand command;
  if (!framed(bytes) || !takeNumbers(bytes, command.motors)) return std::nullopt;
  const unsigned status = static_cast<unsigned>(bytes[13]) - kZero;
  if (status > 0xf) return std::nullopt;
  command.lights = status & 0xe;
  command.homing = status & 1;
  return command;
}

std::optional<FalconReply> decodeFalconReply(std::span<const std::uint8_t> bytes) noexcept {
  FalconReply reply;
  if (!framed(bytes) || !takeNumbers(bytes, reply.encoders)) return std::nullopt;
  const unsigned status = static_cast<unsigned>(bytes[13]) - kZero;
  if (status > 0x7f) return std::nullopt;
  reply.buttons = status & 0xf;
  reply.homed = status >> 4 & 7;
  return reply;
}

bool FalconFramer::push(std::uint8_t byte) noexcept {
  if (byte == '<') {
    dropped_ += size_ > 0;
    size_ = 0;
    stray_ = false;
  } else if (size_ == 0) {
    dropped_ += !std::exchange(stray_, true);
    return false;                              // between frames
  }
  frame_[size_++] = byte;
  const bool ends = byte == '>';
  if (!ends && size_ < kFalconFrame) return false;
  const bool whole = ends && size_ == kFalconFrame;
  dropped_ += !whole;
  stray_ = !whole;                             // what follows a broken frame belongs to it
  size_ = 0;
  return whole;
}

}  // namespace halsted::haptics
