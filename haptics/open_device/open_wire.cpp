#include "haptics/open_device/open_wire.h"

#include <algorithm>
#include <cmath>

namespace halsted::haptics {
namespace {

constexpr std::uint8_t kSync0 = 0xc3, kSync1 = 0x5a;
constexpr std::size_t kIdentityBytes = 32, kStateBytes = 30;

std::uint16_t take16(const std::uint8_t* at) noexcept { return static_cast<std::uint16_t>(at[0] | at[1] << 8); }
double takeSigned16(const std::uint8_t* at) noexcept { return static_cast<std::int16_t>(take16(at)); }
std::uint32_t take32(const std::uint8_t* at) noexcept { return take16(at) | static_cast<std::uint32_t>(take16(at + 2)) << 16; }

void put16(std::uint16_t value, std::uint8_t* at) noexcept {
  at[0] = static_cast<std::uint8_t>(value & 0xff);
  at[1] = static_cast<std::uint8_t>(value >> 8);
}

}  // namespace

std::uint16_t openChecksum(std::span<const std::uint8_t> bytes) noexcept {
  unsigned crc = 0xffff;
  for (const std::uint8_t byte : bytes) {
    crc ^= static_cast<unsigned>(byte) << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000 ? crc << 1 ^ 0x1021 : crc << 1) & 0xffff;
  }
  return static_cast<std::uint16_t>(crc);
}

OpenParse parseOpenFrame(std::span<const std::uint8_t> bytes, OpenFrame& frame, std::size_t& size) noexcept {
  if ((!bytes.empty() && bytes[0] != kSync0) || (bytes.size() > 1 && bytes[1] != kSync1)) return OpenParse::kWrong;
  if (bytes.size() < kOpenHeader) return OpenParse::kMore;
  const std::size_t payload = bytes[5];
  if (payload > kOpenMaxPayload) return OpenParse::kWrong;
  size = kOpenHeader + payload + kOpenCheck;
  if (bytes.size() < size) return OpenParse::kMore;
  if (take16(&bytes[kOpenHeader + payload]) != openChecksum(bytes.subspan(2, kOpenHeader - 2 + payload))) return OpenParse::kWrong;
  frame = {bytes[2], bytes[3], bytes[4], bytes.subspan(kOpenHeader, payload)};
  return OpenParse::kFrame;
}

std::size_t sealOpenFrame(std::uint8_t type, std::uint8_t sequence, std::span<const std::uint8_t> payload, std::span<std::uint8_t> packet) noexcept {
  const std::size_t length = std::min(payload.size(), kOpenMaxPayload);
  if (packet.size() < kOpenHeader + length + kOpenCheck) return 0;
  packet[0] = kSync0;
  packet[1] = kSync1;
  packet[2] = kOpenVersion;
  packet[3] = type;
  packet[4] = sequence;
  packet[5] = static_cast<std::uint8_t>(length);
  std::copy_n(payload.begin(), length, packet.begin() + kOpenHeader);
  put16(openChecksum(packet.subspan(2, kOpenHeader - 2 + length)), &packet[kOpenHeader + length]);
  return kOpenHeader + length + kOpenCheck;
}

bool decodeIdentity(std::span<const std::uint8_t> payload, OpenIdentity& identity) {
  if (payload.size() < kIdentityBytes) return false;
  const std::uint8_t* p = payload.data();
  if (take16(p + 6) == 0 || take16(p + 8) == 0) return false;
  identity.oldest = p[0];
  identity.newest = p[1];
  identity.firmware = take16(p + 2);
  identity.rate = take16(p + 4);
  identity.limits.peakForce = take16(p + 6) * 1e-3;
  identity.limits.continuousForce = std::min(take16(p + 8) * 1e-3, identity.limits.peakForce);
  identity.limits.stiffness = take16(p + 10);
  identity.limits.positionStep = take16(p + 12) * 1e-7;
  identity.serial.clear();
  for (std::size_t i = 16; i < kIdentityBytes && p[i] > 0x20 && p[i] < 0x7f; ++i) identity.serial += static_cast<char>(p[i]);
  return true;
}

bool decodeState(std::span<const std::uint8_t> payload, OpenState& state) noexcept {
  if (payload.size() < kStateBytes) return false;
  const std::uint8_t* p = payload.data();
  state.microseconds = take32(p);
  for (int i = 0; i < 3; ++i) state.pose.position[i] = static_cast<std::int32_t>(take32(p + 4 + 4 * i)) * 1e-7;
  const Quat turned(takeSigned16(p + 16), takeSigned16(p + 18), takeSigned16(p + 20), takeSigned16(p + 22));
  const double length = std::sqrt(turned.squaredNorm());         // [1/32767]
  if (!(length > 16384.0 && length < 49152.0)) return false;
  state.pose.orientation.coeffs() = turned.coeffs() / length;
  state.jaw = take16(p + 24) / 65535.0;
  state.buttons = take16(p + 26);
  state.status = p[28];
  state.lastForce = p[29];
  return true;
}

std::array<std::uint8_t, 8> forcePayload(const Vec3& force, std::uint8_t flags) noexcept {
  std::array<std::uint8_t, 8> payload{};
  for (int i = 0; i < 3; ++i) {
    const double millinewtons = std::isfinite(force[i]) ? std::clamp(std::round(force[i] * 1e3), -32767.0, 32767.0) : 0.0;
    put16(static_cast<std::uint16_t>(static_cast<std::int16_t>(millinewtons)), &payload[static_cast<std::size_t>(2 * i)]);
  }
  payload[6] = flags;
  return payload;
}

}  // namespace halsted::haptics
