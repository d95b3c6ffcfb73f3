#include "scenes/input_text.h"

#include <charconv>
#include <filesystem>
#include <fstream>

namespace halsted::scenes {

std::string readTextFile(const std::string& path, std::size_t limit) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) throw InputError(quoted(path) + ": no such file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(quoted(path) + ": cannot be opened");
  std::string text(limit + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > limit) throw InputError(quoted(path) + ": larger than " + std::to_string(limit) + " bytes");
  return text;
}

std::string quoted(const std::string& text) {
  constexpr std::size_t kLongest = 200;
  std::string out = text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return out;
}

/// RFC 3629.
std::size_t decodeLetter(const std::string& text, std::size_t i, std::uint32_t& letter) {
  const auto lead = static_cast<unsigned char>(text[i]);
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || i + length > text.size()) return 0;
  letter = lead & (0x7fu >> length);
  for (std::size_t k = 1; k < length; ++k) {
    const auto next = static_cast<unsigned char>(text[i + k]);
    if ((next & 0xc0) != 0x80) return 0;
    letter = letter << 6 | (next & 0x3f);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = letter >= 0xd800 && letter <= 0xdfff;
  return letter < kLeast[length] || letter > 0x10ffff || surrogate ? 0 : length;
}

bool isUtf8(const std::string& text) {
  std::uint32_t letter = 0;
  for (std::size_t i = 0, length = 0; i < text.size(); i += length) {
    length = static_cast<unsigned char>(text[i]) < 0x80 ? 1 : decodeLetter(text, i, letter);
    if (length == 0) return false;
  }
  return true;
}

std::string plainNumber(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6).ptr;
  return std::string(buffer, end);
}

}  // namespace halsted::scenes
