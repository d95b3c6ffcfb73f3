#pragma once
/// Host side of the open wire protocol's frames (PROTOCOL.md): fixed-size, no heap, never trusting a length.
#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "haptics/device.h"

namespace halsted::haptics {

inline constexpr std::uint8_t kOpenVersion = 1;
inline constexpr std::size_t kOpenMaxFrame = 64, kOpenHeader = 6, kOpenCheck = 2, kOpenMaxPayload = 56;
enum OpenType : std::uint8_t { kOpenHello = 0x01, kOpenForce = 0x02, kOpenStop = 0x03, kOpenIdentity = 0x81, kOpenState = 0x82, kOpenRefused = 0x83 };
enum OpenStatus : std::uint8_t { kOpenHomed = 1, kOpenForceOn = 2, kOpenWatchdog = 4, kOpenHot = 8, kOpenFault = 16 };

std::uint16_t openChecksum(std::span<const std::uint8_t>) noexcept;

struct OpenFrame { std::uint8_t version = 0, type = 0, sequence = 0; std::span<const std::uint8_t> payload; };

/// One whole frame from `bytes[0]` on; `size` says how many bytes it takes. kMore: not all there yet. kWrong: no frame begins here.
enum class OpenParse { kFrame, kMore, kWrong };
OpenParse parseOpenFrame(std::span<const std::uint8_t> bytes, OpenFrame&, std::size_t& size) noexcept;
/// Returns the size of the frame in `packet`, which holds kOpenMaxFrame.
std::size_t sealOpenFrame(std::uint8_t type, std::uint8_t sequence, std::span<const std::uint8_t> payload, std::span<std::uint8_t> packet) noexcept;

struct OpenIdentity {
  std::uint8_t oldest = 0, newest = 0;
  std::uint16_t firmware = 0, rate = 0;        // rate in Hz
  DeviceLimits limits;
  std::string serial;
};
struct OpenState {
  std::uint32_t microseconds = 0;
  Pose pose;
  double jaw = 1.0;                            // [1]
  std::uint16_t buttons = 0;
  std::uint8_t status = 0, lastForce = 0;
};
/// False when it is too short or declares no peak or no continuous force: the limits divide by it.
bool decodeIdentity(std::span<const std::uint8_t> payload, OpenIdentity&);
/// False when it is too short or its quaternion has no length.
bool decodeState(std::span<const std::uint8_t> payload, OpenState&) noexcept;
/// 8 bytes: millinewtons and flags. What is not finite becomes zero; larger than the format is cut.
std::array<std::uint8_t, 8> forcePayload(const Vec3& force, std::uint8_t flags) noexcept;   // [N]

}  // namespace halsted::haptics
