/// Readers of motion files.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "haptics/hd/motion.h"

namespace halsted::haptics::hd {

namespace {

constexpr std::size_t kMostSamples = 4'000'000;   // an hour at 1 kHz
constexpr double kFarthest = 1.0;                 // [m] no hand held device reaches farther
constexpr double kLatest = 1e11;                  // [s] clocks count from 1970; differences stay numbers
constexpr double kTwoPi = 6.283185307179586;      // [rad]

struct Source {
  std::string path;
  int line = 0;

  [[noreturn]] void fail(const std::string& what) const {
    throw MotionError(path + ":" + std::to_string(line) + ": " + what);
  }
};

using Fields = std::vector<std::string_view>;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\"";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Commas where there is one, else white space.
Fields split(std::string_view line) {
  Fields fields;
  const bool commas = line.find(',') != std::string_view::npos;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(commas ? line.find(',', at) : line.find_first_of(" \t", at), line.size());
    const std::string_view field = trimmed(line.substr(at, end - at));
    if (commas || !field.empty()) fields.push_back(field);
    at = end + 1;
  }
  return fields;
}

double number(const Source& source, std::string_view field) {
  double value = 0.0;  // [1]
  const auto [end, failure] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (failure != std::errc{} || end != field.data() + field.size() || !std::isfinite(value))
    source.fail("not a number: '" + std::string(field.substr(0, 20)) + "'");
  return value;
}

/// Where the columns of a table are; -1: not there.
struct Columns {
  int time = -1, buttons = -1, inkwell = -1;
  std::array<int, 3> position{-1, -1, -1};
  std::array<int, 4> turn{-1, -1, -1, -1};       // x y z w
  double unit = 1.0;                             // [m] of the positions
};

int find(const Fields& names, std::initializer_list<const char*> wanted) {
  for (const char* name : wanted)
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == name) return static_cast<int>(i);
  return -1;
}

Columns readHeader(const Source& source, const Fields& names) {
  Columns columns;
  columns.time = find(names, {"t_s", "time_s", "header_stamp_s", "bag_time_s"});
  const bool millimetres = find(names, {"x_mm", "px_mm"}) >= 0;
  columns.unit = millimetres ? 1e-3 : 1.0;
  const std::string suffix = millimetres ? "_mm" : "_m";
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name = std::string(1, "xyz"[axis]) + suffix, recorded = "p" + name;
    columns.position[axis] = find(names, {name.c_str(), recorded.c_str()});
    if (columns.position[axis] < 0) source.fail("no column '" + name + "'");
  }
  constexpr const char* kTurn[] = {"qx", "qy", "qz", "qw"};
  for (int i = 0; i < 4; ++i) columns.turn[i] = find(names, {kTurn[i]});
  columns.buttons = find(names, {"buttons"});
  columns.inkwell = find(names, {"inkwell"});
  if (columns.time < 0) source.fail("no column 't_s'");
  return columns;
}

double fieldOf(const Source& source, const Fields& fields, int column) {
  if (column >= static_cast<int>(fields.size())) source.fail("too few columns");
  return number(source, fields[column]);
}

MotionSample readRow(const Source& source, const Columns& columns, const Fields& fields) {
  MotionSample sample;
  sample.time = fieldOf(source, fields, columns.time);
  for (int axis = 0; axis < 3; ++axis) {
    sample.pose.position[axis] = fieldOf(source, fields, columns.position[axis]) * columns.unit;
    if (std::abs(sample.pose.position[axis]) > kFarthest) source.fail("position farther than 1 m");
  }
  if (*std::min_element(columns.turn.begin(), columns.turn.end()) >= 0) {
    for (int i = 0; i < 4; ++i) sample.pose.orientation.coeffs()[i] = fieldOf(source, fields, columns.turn[i]);
    const double size = sample.pose.orientation.norm();
    if (!(size > 0.5 && size < 2.0)) source.fail("not a unit quaternion");
    sample.pose.orientation.coeffs() /= size;
  }
  if (columns.buttons >= 0) {
    const double mask = fieldOf(source, fields, columns.buttons);
    if (!(mask >= 0.0 && mask <= 15.0)) source.fail("buttons: a mask from 0 to 15");
    sample.buttons = static_cast<unsigned>(mask);
  }
  sample.inkwell = columns.inkwell >= 0 && fieldOf(source, fields, columns.inkwell) != 0.0;
  return sample;
}

/// Tool dynamometer: a spindle turned by hand, 8192 counts a turn. The hand is shown turning a lever of 50 mm about the vertical:
/// the tip moves on that arc, the stylus turns with it.
MotionSample readTurn(const Source& source, const Fields& fields) {
  constexpr double kCounts = 8192.0, kLever = 0.05;  // [1/turn] [m]
  MotionSample sample;
  sample.time = fieldOf(source, fields, 0);  // [s], whatever the trace's own header says
  const double angle = fieldOf(source, fields, 1) / kCounts * kTwoPi;  // [rad]
  sample.pose.position = Vec3(std::sin(angle), 0.0, std::cos(angle) - 1.0) * kLever;
  sample.pose.orientation = Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()));
  return sample;
}

void append(const Source& source, MotionSample sample, double& start, Motion& motion) {
  if (motion.samples.empty()) start = sample.time;
  if (!(std::abs(sample.time) <= kLatest)) source.fail("a time that no clock shows");
  sample.time -= start;
  if (!motion.samples.empty() && !(sample.time > motion.samples.back().time)) {
    if (sample.time == motion.samples.back().time) return;  // recorders write the same instant twice
    source.fail("time runs backwards");
  }
  if (motion.samples.size() >= kMostSamples) source.fail("more than 4 million rows");
  motion.samples.push_back(sample);
}

}  // namespace

Motion readMotion(const std::string& path) {
  std::ifstream in(path);
  if (!in) Source{path}.fail("cannot be read");
  return readMotion(in, path);
}

Motion readMotion(std::istream& in, const std::string& path) {
  Source source{path};
  Motion motion;
  std::optional<Columns> columns;
  bool trace = false;
  double start = 0.0;  // [s]
  for (std::string line; std::getline(in, line);) {
    ++source.line;
    const std::string_view text = trimmed(line);
    if (text.empty() || text[0] == '#') continue;
    if (text[0] == '%') {
      trace = true;
      continue;
    }
    const Fields fields = split(text);
    if (trace) append(source, readTurn(source, fields), start, motion);
    else if (!columns) columns = readHeader(source, fields);
    else append(source, readRow(source, *columns, fields), start, motion);
  }
  if (motion.samples.empty()) source.fail("no samples");
  return motion;
}

}  // namespace halsted::haptics::hd
