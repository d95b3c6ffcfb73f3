#include "scenes/toml_guard.h"

#include <cstring>

#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

/// Where a character stands. A quote that is not closed ends with its line, where toml++ stops as well.
struct Place {
  char quote = 0;          // the open quote, 0 outside
  bool threefold = false;  // it is a """ or '''
  bool comment = false;

  bool bare() const { return quote == 0 && !comment; }

  /// Takes what starts at `i` and returns how many characters that was.
  std::size_t take(const std::string& text, std::size_t i) {
    const char c = text[i];
    if (c == '\n') {
      comment = false;
      if (!threefold) quote = 0;
      return 1;
    }
    if (comment) return 1;
    if (quote == 0) return open(text, i);
    if (c == '\\' && quote == '"') return i + 1 < text.size() && text[i + 1] != '\n' ? 2 : 1;
    if (c != quote) return 1;
    if (threefold && text.compare(i, 3, std::string(3, quote)) != 0) return 1;
    const std::size_t length = threefold ? 3 : 1;
    quote = 0;
    threefold = false;
    return length;
  }

  std::size_t open(const std::string& text, std::size_t i) {
    comment = text[i] == '#';
    if (text[i] != '"' && text[i] != '\'') return 1;
    quote = text[i];
    threefold = text.compare(i, 3, std::string(3, quote)) == 0;
    return threefold ? 3 : 1;
  }
};

bool isControl(unsigned char c) { return (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7f; }

/// After a bracket a table's name, a value or another bracket begins.
bool mayFollowBracket(const std::string& text, std::size_t i) {
  constexpr const char* kMarks = "_-+\"'[]{#\r\n";
  while (i < text.size() && (text[i] == ' ' || text[i] == '\t')) ++i;
  if (i >= text.size()) return true;
  const char c = text[i];
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || std::strchr(kMarks, c);
}

/// A quote inside a word (0"...) is never TOML, and toml++ then goes on reading what follows as if it stood outside the quotes.
bool mayPrecedeQuote(const std::string& text, std::size_t i) { return i == 0 || std::strchr(" \t\r\n=[,{.", text[i - 1]); }

}  // namespace

void refuseUnsafeToml(const std::string& text, const std::string& origin) {
  Place place;
  long line = 1;
  const auto fail = [&](const char* what) { throw InputError(quoted(origin) + ":" + std::to_string(line) + ": " + what); };
  for (std::size_t i = 0; i < text.size();) {
    const bool bare = place.bare();
    const std::size_t next = i + place.take(text, i);
    if (bare && !place.bare() && !place.comment && !mayPrecedeQuote(text, i)) fail("a quote in the middle of a word");
    for (; i < next; ++i) {
      if (isControl(static_cast<unsigned char>(text[i]))) fail("a control character");
      if (bare && static_cast<unsigned char>(text[i]) >= 0x80) fail("a letter outside ASCII, outside quotes");
      if (bare && text[i] == '[' && !mayFollowBracket(text, i + 1)) fail("'[' without a name or value");
      if (text[i] == '\n') ++line;
    }
  }
}

}  // namespace halsted::scenes
