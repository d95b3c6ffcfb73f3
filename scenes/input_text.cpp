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

std::string plainNumber(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6).ptr;
  return std::string(buffer, end);
}

}  // namespace halsted::scenes
