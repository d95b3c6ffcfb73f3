#pragma once
/// Words and numbers from a text file, streamed through a fixed buffer, with the line number for messages.
#include <array>
#include <istream>
#include <string>

#include "scenes/scene.h"

namespace halsted::scenes {

class TextScanner {
 public:
  TextScanner(std::istream& in, std::string origin) : in_(in), origin_(std::move(origin)) {}

  /// Next word anywhere; false at the end of the file.
  bool word(std::string& out);
  /// Next word of the current line; false at its end.
  bool wordInLine(std::string& out);
  /// Moves past the end of the current line; false at the end of the file.
  bool nextLine();
  /// The rest of the current line, without blanks at its ends, cut at 256 characters.
  std::string restOfLine();

  double number();                 // [file's unit] next word anywhere as a number
  long long integer();
  double toNumber(const std::string& text) const;     // [file's unit]
  long long toInteger(const std::string& text) const;

  std::string where() const { return origin_ + ":" + std::to_string(line_); }
  [[noreturn]] void fail(const std::string& message) const;

 private:
  int peek();                      // next character or -1
  void skip();                     // consumes what peek returned
  void collectWord(std::string& out);

  std::istream& in_;
  std::string origin_;
  std::array<char, 1 << 16> buffer_{};
  std::size_t at_ = 0, filled_ = 0;
  long long line_ = 1;
  std::string scratch_;
};

}  // namespace halsted::scenes
