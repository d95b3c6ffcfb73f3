#pragma once
/// Little-endian values from a binary file.
#include <cstdint>
#include <cstring>
#include <istream>

namespace halsted::scenes {

/// False at the end of the file. T is an integer or floating-point type of 1, 2, 4 or 8 bytes.
template <typename T>
bool readLittleEndian(std::istream& in, T& out) {
  unsigned char bytes[sizeof(T)];
  if (!in.read(reinterpret_cast<char*>(bytes), sizeof(T))) return false;
  std::uint64_t bits = 0;
  for (std::size_t i = sizeof(T); i-- > 0;) bits = bits << 8 | bytes[i];
  if constexpr (sizeof(T) == 8) {
    std::memcpy(&out, &bits, 8);
  } else if constexpr (sizeof(T) == 4) {
    const auto low = static_cast<std::uint32_t>(bits);
    std::memcpy(&out, &low, 4);
  } else if constexpr (sizeof(T) == 2) {
    const auto low = static_cast<std::uint16_t>(bits);
    std::memcpy(&out, &low, 2);
  } else {
    std::memcpy(&out, bytes, 1);
  }
  return true;
}

}  // namespace halsted::scenes
