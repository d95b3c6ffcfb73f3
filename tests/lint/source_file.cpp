#include "tests/lint/source_file.h"

#include <regex>

namespace halsted::lint {
namespace {

enum class Mode { kCode, kLine, kBlock, kString, kChar };

/// Advances over one character; returns the mode that the character itself belongs to.
Mode advance(Mode& mode, const std::string& text, std::size_t& i) {
  const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : '\0';
  const Mode here = mode;
  if (mode == Mode::kCode) {
    const bool digitSeparator = c == '\'' && i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1]));
    if (c == '/' && next == '/') mode = Mode::kLine;
    if (c == '/' && next == '*') mode = Mode::kBlock;
    if (c == '"') mode = Mode::kString;
    if (c == '\'' && !digitSeparator) mode = Mode::kChar;
    return mode == Mode::kLine || mode == Mode::kBlock ? mode : here;
  }
  if (mode == Mode::kLine && c == '\n') mode = Mode::kCode;
  if (mode == Mode::kBlock && c == '/' && i > 0 && text[i - 1] == '*') mode = Mode::kCode;
  if ((mode == Mode::kString && c == '"') || (mode == Mode::kChar && c == '\'')) { mode = Mode::kCode; return Mode::kCode; }
  return here;
}

/// Length of a raw string literal that starts at `i`, or 0.
std::size_t rawStringLength(const std::string& text, std::size_t i) {
  if (text.compare(i, 2, "R\"") != 0) return 0;
  const std::size_t open = text.find('(', i);
  if (open == std::string::npos) return 0;
  const std::string close = ")" + text.substr(i + 2, open - i - 2) + "\"";
  const std::size_t end = text.find(close, open);
  return end == std::string::npos ? 0 : end + close.size() - i;
}

BlockKind kindOf(const std::string& header, bool inFunction) {
  static const std::regex kNamespace(R"(\bnamespace\b|\bextern\s*"?)"), kType(R"(\b(struct|class|union|enum)\b)");
  static const std::regex kControl(R"(^\s*(\}\s*)?(else|if|for|while|switch|do|try|catch|case)\b)");
  if (inFunction) {
    if (std::regex_search(header, kControl)) return BlockKind::kControl;
    return std::regex_search(header, kType) && header.find('(') == std::string::npos ? BlockKind::kType : BlockKind::kOther;
  }
  if (std::regex_search(header, kNamespace)) return BlockKind::kNamespace;
  if (std::regex_search(header, kType) && header.find('(') == std::string::npos) return BlockKind::kType;
  if (header.find('=') != std::string::npos && header.find('(') == std::string::npos) return BlockKind::kOther;
  return BlockKind::kFunction;
}

}  // namespace

SourceFile split(const std::string& path, const std::string& text) {
  SourceFile file{path, {""}, {""}, {""}};
  Mode mode = Mode::kCode;
  std::size_t rawUntil = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (mode == Mode::kCode && i >= rawUntil) rawUntil = std::max(rawUntil, i + rawStringLength(text, i));
    const bool inRaw = i < rawUntil;
    if (!inRaw && i > 0 && text[i - 1] == '\\' && (mode == Mode::kString || mode == Mode::kChar)) {   // an escaped character
      const bool escaped = !(i > 1 && text[i - 2] == '\\');
      if (escaped) { file.raw.back() += text[i]; file.code.back() += ' '; file.comment.back() += ' '; continue; }
    }
    const Mode here = inRaw ? Mode::kString : advance(mode, text, i);
    if (text[i] == '\n') {
      for (auto* lines : {&file.raw, &file.code, &file.comment}) lines->emplace_back();
      continue;
    }
    file.raw.back() += text[i];
    file.code.back() += here == Mode::kCode ? text[i] : ' ';
    file.comment.back() += here == Mode::kLine || here == Mode::kBlock ? text[i] : ' ';
  }
  if (file.raw.back().empty()) { file.raw.pop_back(); file.code.pop_back(); file.comment.pop_back(); }
  return file;
}

std::vector<Block> blocks(const SourceFile& file) {
  std::vector<Block> done, open;
  std::string header;
  int functions = 0, parentheses = 0;
  for (int line = 1; line <= static_cast<int>(file.code.size()); ++line) {
    const std::string& code = file.code[line - 1];
    if (code.find_first_not_of(' ') != std::string::npos && code[code.find_first_not_of(' ')] == '#') continue;
    for (const char c : code) {
      parentheses += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (c == '{') {
        Block block{kindOf(header, functions > 0), line, line, 0};
        if (block.kind == BlockKind::kFunction) ++functions;
        for (const Block& outer : open) block.controlDepth += outer.kind == BlockKind::kControl;
        block.controlDepth += block.kind == BlockKind::kControl;
        open.push_back(block);
        header.clear();
      } else if (c == '}' && !open.empty()) {
        open.back().lastLine = line;
        if (open.back().kind == BlockKind::kFunction) --functions;
        done.push_back(open.back());
        open.pop_back();
        header.clear();
      } else if (c == ';' && parentheses <= 0) {
        header.clear();
        parentheses = 0;
      } else {
        header += c;
      }
    }
    header += ' ';
  }
  return done;
}

}  // namespace halsted::lint
