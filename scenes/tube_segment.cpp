#include "scenes/tube_segment.h"

#include <charconv>

#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

double fraction(const std::string& part, const std::string& whole) {  // [1]
  double value = 0.0;  // [1]
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (error != std::errc() || end != part.data() + part.size() || !(value >= 0.0 && value <= 1.0))
    throw InputError("'" + quoted(whole) + "' is not start, end, a fraction 0 to 1, or rim:end as two fractions");
  return value;
}

}  // namespace

TubeSegment parseSegment(const std::string& text) {
  using Kind = TubeSegment::Kind;
  if (text.empty()) return {Kind::kBest};
  if (text == "start") return {Kind::kStart};
  if (text == "end") return {Kind::kEnd, 1.0};
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return {Kind::kAt, fraction(text, text)};
  TubeSegment segment{Kind::kRange, fraction(text.substr(0, colon), text), fraction(text.substr(colon + 1), text)};
  if (segment.rim == segment.farEnd) throw InputError("'" + quoted(text) + "' has no length");
  return segment;
}

}  // namespace halsted::scenes
