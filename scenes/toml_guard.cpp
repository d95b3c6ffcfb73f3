#include "scenes/toml_guard.h"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

/// Where a character stands. A quote that is not closed ends with its line, where toml++ refuses the text.
struct Place {
  char quote = 0;          // the open quote, 0 outside
  bool threefold = false;  // it is a """ or '''
  bool comment = false;

  bool bare() const { return quote == 0 && !comment; }

  /// Takes what starts at `i` and returns how many characters that was; a backslash and what follows it go together.
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
    return c == quote ? close(text, i) : 1;
  }

  std::size_t open(const std::string& text, std::size_t i) {
    comment = text[i] == '#';
    if (text[i] != '"' && text[i] != '\'') return 1;
    quote = text[i];
    threefold = text.compare(i, 3, std::string(3, quote)) == 0;
    return threefold ? 3 : 1;
  }

  /// Up to two quotes before the closing three belong to the text.
  std::size_t close(const std::string& text, std::size_t i) {
    std::size_t length = 1;
    while (threefold && length < 5 && i + length < text.size() && text[i + length] == quote) ++length;
    if (threefold && length < 3) return length;
    quote = 0;
    threefold = false;
    return length;
  }
};

bool isControl(unsigned char c) { return (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7f; }

/// After a bracket a table's name, a value or another bracket begins.
bool mayFollowBracket(const std::string& text, std::size_t i) {
  constexpr const char* kMarks = "_-+\"'[]{#\r\n";
  while (i < text.size() && (text[i] == ' ' || text[i] == '\t')) ++i;
  if (i >= text.size()) return true;
  const char c = text[i];
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || (c && std::strchr(kMarks, c));
}

/// How deep the tables go that a text asks for: each dot of a key is one level, and toml++ walks the levels by recursion. A key has none of the
/// marks that end it; keys within one bracket add up. The dots of a number are not a key's: no '=' follows them.
struct KeyDepth {
  static constexpr int kMostParts = 64, kMostTogether = 1024;    // [1] of one key; dots of all keys from a first bracket to where the last one closes
  int dots = 0, together = 0, open = 0;        // [1]

  /// Of a character outside texts and comments. False: too deep.
  bool take(char c) {
    if (c == '.') return ++dots < kMostParts;
    const bool ends = c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}' || c == '\n';
    if (!ends) return true;
    if (c == '[' || c == '{') ++open;
    if (c == ']' || c == '}') --open;
    if (c == '=') together += dots;
    if (c == '\n' && open <= 0) together = open = 0;
    dots = 0;
    return together <= kMostTogether;
  }
};

/// Copies text piece by piece, always knowing the line.
struct AsciiWriter {
  const std::string& text;
  const std::string& origin;
  std::string out;
  long line = 1;
  KeyDepth depth{};

  [[noreturn]] void fail(const char* what) const { throw InputError(quoted(origin) + ":" + std::to_string(line) + ": " + what); }

  void addAscii(std::size_t i, bool bare) {
    if (isControl(static_cast<unsigned char>(text[i]))) fail("a control character");
    if (bare && text[i] == '[' && !mayFollowBracket(text, i + 1)) fail("'[' without a name or value");
    if ((bare || text[i] == '\n') && !depth.take(text[i])) fail("a key of more than 64 parts, or too many in one another");
    if (text[i] == '\n') ++line;
    out.push_back(text[i]);
  }

  std::size_t addLetter(std::size_t i, const Place& place) {
    std::uint32_t letter = 0;
    const std::size_t length = decodeLetter(text, i, letter);
    if (length == 0) fail("bytes that are not UTF-8");
    if (place.comment) {
      out.push_back('?');
      return length;
    }
    if (place.quote != '"') fail("a letter outside ASCII, outside double quotes");
    char escaped[16];
    std::snprintf(escaped, sizeof escaped, letter > 0xffff ? "\\U%08X" : "\\u%04X", static_cast<unsigned>(letter));
    out += escaped;
    return length;
  }
};

}  // namespace

std::string asciiToml(const std::string& text, const std::string& origin) {
  Place place;
  AsciiWriter writer{text, origin, {}, 1};
  for (std::size_t i = 0; i < text.size();) {
    if (static_cast<unsigned char>(text[i]) >= 0x80) {
      i += writer.addLetter(i, place);
      continue;
    }
    const bool bare = place.bare();
    for (const std::size_t next = i + place.take(text, i); i < next; ++i) {
      if (static_cast<unsigned char>(text[i]) >= 0x80) writer.fail("a backslash before a letter outside ASCII");
      writer.addAscii(i, bare);
    }
  }
  return std::move(writer.out);
}

}  // namespace halsted::scenes
