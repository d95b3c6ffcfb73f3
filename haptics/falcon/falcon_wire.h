#pragma once
/// The Falcon's run mode: 16 characters each way, '<', three signed 16-bit numbers of four nibbles each, two characters, '>'. A nibble
/// is 'A' + value, least significant first. There is no checksum: what is not a nibble, or jumps, is refused. Pure, no heap.
#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace halsted::haptics {

inline constexpr std::size_t kFalconFrame = 16;
inline constexpr int kFalconMotorLimit = 4096;                   // counts; what public drivers send at most
enum FalconLight : std::uint8_t { kFalconGreen = 2, kFalconBlue = 4, kFalconRed = 8 };
enum FalconButton : std::uint8_t { kFalconPlus = 1, kFalconForward = 2, kFalconCentre = 4, kFalconMinus = 8 };
inline constexpr std::uint8_t kFalconAllHomed = 7;               // one bit a leg

struct FalconCommand { std::array<int, 3> motors{}; std::uint8_t lights = 0; bool homing = false; };
struct FalconReply { std::array<int, 3> encoders{}; std::uint8_t buttons = 0, homed = 0; };

using FalconFrame = std::array<std::uint8_t, kFalconFrame>;
FalconFrame encode(const FalconCommand&) noexcept;               // motors are cut at the limit
FalconFrame encode(const FalconReply&) noexcept;
std::optional<FalconCommand> decodeFalconCommand(std::span<const std::uint8_t>) noexcept;
std::optional<FalconReply> decodeFalconReply(std::span<const std::uint8_t>) noexcept;

/// Cuts frames out of a byte stream: begins again at every '<', drops what does not end where it must.
class FalconFramer {
 public:
  /// True when `frame()` has just become whole.
  bool push(std::uint8_t byte) noexcept;
  const FalconFrame& frame() const noexcept { return frame_; }
  std::uint64_t dropped() const noexcept { return dropped_; }    // frames begun and not ended, and runs of bytes outside any

 private:
  FalconFrame frame_{};
  std::size_t size_ = 0;
  std::uint64_t dropped_ = 0;
  bool stray_ = false;
};

}  // namespace halsted::haptics
