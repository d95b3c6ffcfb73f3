#pragma once
/// A state's hash as it is printed and recorded. Any thread.
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <string>

namespace halsted::app {

inline std::string hexadecimal(std::uint64_t value) {
  char digits[20];
  std::snprintf(digits, sizeof digits, "%016" PRIx64, value);
  return digits;
}

}  // namespace halsted::app
