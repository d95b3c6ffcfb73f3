#include "scenes/mesh_readers/ply_header.h"

#include <charconv>
#include <utility>

#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

constexpr long long kMostLines = 1000;
constexpr std::size_t kLongestLine = 1000;

constexpr std::pair<const char*, PlyType> kTypes[] = {
    {"char", PlyType::kInt8},     {"int8", PlyType::kInt8},     {"uchar", PlyType::kUint8},   {"uint8", PlyType::kUint8},
    {"short", PlyType::kInt16},   {"int16", PlyType::kInt16},   {"ushort", PlyType::kUint16}, {"uint16", PlyType::kUint16},
    {"int", PlyType::kInt32},     {"int32", PlyType::kInt32},   {"uint", PlyType::kUint32},   {"uint32", PlyType::kUint32},
    {"float", PlyType::kFloat},   {"float32", PlyType::kFloat}, {"double", PlyType::kDouble}, {"float64", PlyType::kDouble}};

struct HeaderLines {
  std::istream& in;
  std::string origin;
  PlyHeader header;

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(origin + ":" + std::to_string(header.lines) + ": " + message);
  }

  /// The words of the next line. Reads byte by byte: what follows the header may be binary.
  std::vector<std::string> next() {
    if (++header.lines > kMostLines) fail("the header has no end_header");
    std::vector<std::string> words;
    std::size_t length = 0;
    bool inWord = false;
    for (int c = in.get(); c != '\n'; c = in.get()) {
      if (c < 0) fail("the file ends in its header");
      if (++length > kLongestLine) fail("a header line of more than 1000 characters");
      const bool blank = c == ' ' || c == '\t' || c == '\r';
      if (!blank && !inWord) words.emplace_back();
      if (!blank) words.back().push_back(static_cast<char>(c));
      inWord = !blank;
    }
    return words;
  }

  PlyType type(const std::string& text) const {
    for (const auto& [name, meaning] : kTypes)
      if (text == name) return meaning;
    fail("unknown type '" + quoted(text) + "'");
  }

  void addElement(const std::vector<std::string>& words) {
    if (words.size() != 3) fail("an element needs a name and a count");
    PlyElement element{words[1], 0, {}};
    const char* end = words[2].data() + words[2].size();
    const auto result = std::from_chars(words[2].data(), end, element.count);
    if (result.ec != std::errc() || result.ptr != end || element.count < 0) fail("'" + quoted(words[2]) + "' is not a count");
    header.elements.push_back(element);
  }

  void addProperty(const std::vector<std::string>& words) {
    if (header.elements.empty()) fail("a property before any element");
    PlyProperty property;
    property.isList = words.size() == 5 && words[1] == "list";
    if (!property.isList && words.size() != 3) fail("a property needs a type and a name");
    if (property.isList) property.countType = type(words[2]);
    property.type = type(words[words.size() - 2]);
    property.name = words.back();
    header.elements.back().properties.push_back(property);
  }

  void setFormat(const std::vector<std::string>& words) {
    const std::string format = words.size() > 1 ? words[1] : "";
    header.binary = format == "binary_little_endian";
    if (!header.binary && format != "ascii")
      fail("format '" + quoted(format) + "' is not read, only ascii and binary_little_endian");
  }
};

}  // namespace

PlyHeader readPlyHeader(std::istream& in, const std::string& origin) {
  HeaderLines lines{in, origin, {}};
  if (lines.next() != std::vector<std::string>{"ply"}) lines.fail("is not a PLY file");
  bool hasFormat = false;
  for (auto words = lines.next(); words.empty() || words[0] != "end_header"; words = lines.next()) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "format") {
      lines.setFormat(words);
      hasFormat = true;
    } else if (words[0] == "element") lines.addElement(words);
    else if (words[0] == "property") lines.addProperty(words);
    else lines.fail("unknown keyword '" + quoted(words[0]) + "'");
  }
  if (!hasFormat) lines.fail("the header names no format");
  return lines.header;
}

}  // namespace halsted::scenes
