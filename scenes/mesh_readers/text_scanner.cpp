#include "scenes/mesh_readers/text_scanner.h"

#include <charconv>

#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

constexpr std::size_t kLongestWord = 256;

bool isBlank(int c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// from_chars takes no leading plus sign, which some exporters write.
const char* withoutPlus(const std::string& text) { return text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0); }

}  // namespace

int TextScanner::peek() {
  if (at_ == filled_) {
    in_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    filled_ = static_cast<std::size_t>(in_.gcount());
    at_ = 0;
    if (filled_ == 0) return -1;
  }
  return static_cast<unsigned char>(buffer_[at_]);
}

void TextScanner::skip() {
  if (buffer_[at_++] == '\n') ++line_;
}

void TextScanner::collectWord(std::string& out) {
  out.clear();
  for (int c = peek(); c >= 0 && c != '\n' && !isBlank(c); c = peek()) {
    if (out.size() == kLongestWord) fail("a word of more than 256 characters");
    out.push_back(static_cast<char>(c));
    skip();
  }
}

bool TextScanner::wordInLine(std::string& out) {
  while (isBlank(peek())) skip();
  if (peek() < 0 || peek() == '\n') return false;
  collectWord(out);
  return true;
}

bool TextScanner::word(std::string& out) {
  while (isBlank(peek()) || peek() == '\n') skip();
  if (peek() < 0) return false;
  collectWord(out);
  return true;
}

bool TextScanner::nextLine() {
  while (peek() >= 0 && peek() != '\n') skip();
  if (peek() < 0) return false;
  skip();
  return true;
}

std::string TextScanner::restOfLine() {
  std::string rest;
  while (isBlank(peek())) skip();
  for (int c = peek(); c >= 0 && c != '\n'; c = peek()) {
    if (rest.size() < kLongestWord) rest.push_back(static_cast<char>(c));
    skip();
  }
  while (!rest.empty() && isBlank(rest.back())) rest.pop_back();
  return rest;
}

double TextScanner::toNumber(const std::string& text) const {
  double value = 0.0;  // [file's unit]
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(withoutPlus(text), end, value);
  if (result.ec == std::errc::result_out_of_range) fail("'" + quoted(text) + "' is too large or too small a number");
  if (result.ec != std::errc() || result.ptr != end) fail("'" + quoted(text) + "' is not a number");
  return value;
}

long long TextScanner::toInteger(const std::string& text) const {
  long long value = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(withoutPlus(text), end, value);
  if (result.ec != std::errc() || result.ptr != end) fail("'" + quoted(text) + "' is not an integer");
  return value;
}

double TextScanner::number() {
  if (!word(scratch_)) fail("the file ends where a number should be");
  return toNumber(scratch_);
}

long long TextScanner::integer() {
  if (!word(scratch_)) fail("the file ends where an integer should be");
  return toInteger(scratch_);
}

void TextScanner::fail(const std::string& message) const { throw InputError(where() + ": " + message); }

}  // namespace halsted::scenes
