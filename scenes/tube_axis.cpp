#include "scenes/tube_axis.h"

#include <algorithm>
#include <array>

#include "scenes/input_text.h"
#include "scenes/scene.h"

namespace halsted::scenes {
namespace {

constexpr int kRays = 36;                      // per section while centring
constexpr int kCentringRounds = 6;
constexpr double kCentringShare = 0.6;         // [1] of the rays that a section needs to move the line
constexpr double kClosedShare = 0.94;          // [1] of the rays that a section needs to count as closed
constexpr double kNarrowShare = 0.6;           // [1] of the median radius: beyond the ends of a closed tube it narrows to a cap
constexpr double kLeastClosed = 0.4;           // [1] of all sections, for a tube
constexpr double kLeastAspect = 2.0;           // [1] length over diameter, for a tube
constexpr double kLeastRadius = 5e-3, kMostRadius = 60e-3;  // [m] of any colon, empty or blown up
constexpr double kOtherLoop = 2.2;             // [1] of the median radius: farther walls are another loop's

struct MeasuredSection {
  double radius = 0.0;                         // [m] 0: not measured
  bool closed = false;
};

double median(std::vector<double> values) {  // [m]
  if (values.empty()) return 0.0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Moves every point of the line to the middle of its section.  limit [m], 0 = not known yet
std::vector<MeasuredSection> centre(Centreline& line, const TubeSlicer& slicer, double limit) {
  std::vector<MeasuredSection> measured(line.points.size());
  std::vector<Vec3> points = line.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SectionFrame frame = planeAt(line, line.spacing * static_cast<double>(i));
    Section section = slicer.cut(frame, kRays);
    if (limit > 0.0) section.dropBeyond(limit);
    const int found = kRays - section.missing();
    if (found < kCentringShare * kRays) continue;
    section.fill();
    measured[i] = {section.meanRadius(), found >= kClosedShare * kRays};
    const Vec3 shift = section.centroid(frame) - points[i];
    points[i] += shift * std::min(1.0, 0.5 * measured[i].radius / std::max(shift.norm(), 1e-12));
  }
  line.points = points;
  return measured;
}

double medianRadius(const std::vector<MeasuredSection>& sections) {  // [m]
  std::vector<double> radii;  // [m]
  for (const MeasuredSection& section : sections)
    if (section.radius > 0.0) radii.push_back(section.radius);
  return median(radii);
}

bool usable(const MeasuredSection& section, double radius) { return section.closed && section.radius > kNarrowShare * radius; }  // [m]

/// First and last usable section; first > last when there is none.
std::array<int, 2> usableRange(const std::vector<MeasuredSection>& sections, double radius) {  // [m]
  int first = 0, last = static_cast<int>(sections.size()) - 1;
  while (first <= last && !usable(sections[first], radius)) ++first;
  while (last >= first && !usable(sections[last], radius)) --last;
  return {first, last};
}

/// Cuts the line where the wall stops closing round it and goes on straight from there: the first guess starts at a point of the
/// rim, not at its middle, so its ends lean.
void straightenEnds(Centreline& line, const std::vector<MeasuredSection>& sections, double radius) {  // [m]
  const auto [first, last] = usableRange(sections, radius);
  const int reach = std::max(1, static_cast<int>(radius / line.spacing));
  if (last - first < 2 * reach) return;
  const Vec3 back = (line.points[first] - line.points[first + reach]) / reach;
  const Vec3 onward = (line.points[last] - line.points[last - reach]) / reach;
  std::vector<Vec3> points;
  for (int k = reach; k > 0; --k) points.push_back(line.points[first] + k * back);
  points.insert(points.end(), line.points.begin() + first, line.points.begin() + last + 1);
  for (int k = 1; k <= reach; ++k) points.push_back(line.points[last] + k * onward);
  line.points = points;
  line = resampled(line, line.spacing);
}

std::string millimetres(double metres) { return plainNumber(metres * 1e3) + " mm"; }

void refuseNonTube(const TubeAxis& axis, const std::vector<MeasuredSection>& sections) {
  const auto closed = std::count_if(sections.begin(), sections.end(), [](const MeasuredSection& s) { return s.closed; });
  const double share = static_cast<double>(closed) / static_cast<double>(sections.size());  // [1]
  if (share < kLeastClosed)
    throw InputError("is not a tube: the wall closes round only " + std::to_string(static_cast<int>(share * 100.0)) +
                     " % of its middle line");
  const auto [first, last] = usableRange(sections, axis.radius);
  const double length = axis.line.spacing * std::max(0, last - first);  // [m]
  if (length < kLeastAspect * 2.0 * axis.radius)
    throw InputError("is not a tube: about " + millimetres(length) + " long and " + millimetres(2.0 * axis.radius) + " wide");
  if (axis.radius < kLeastRadius || axis.radius > kMostRadius)
    throw InputError("the tube's radius is " + millimetres(axis.radius) + " at this anatomy.scale, a colon's is " +
                     millimetres(kLeastRadius) + " to " + millimetres(kMostRadius) + ": wrong scale?");
}

}  // namespace

SectionFrame planeAt(const Centreline& line, double distance) { return uprightFrame(line.at(distance), line.tangent(distance)); }

TubeAxis tubeAxis(const Surface& surface, const TubeSlicer& slicer) {
  TubeAxis axis;
  axis.line = traceCentreline(surface);
  std::vector<MeasuredSection> sections;
  for (int round = 0; round < kCentringRounds; ++round) {
    sections = centre(axis.line, slicer, kOtherLoop * axis.radius);
    axis.radius = medianRadius(sections);
    if (!(axis.radius > 0.0)) continue;
    straightenEnds(axis.line, sections, axis.radius);
    axis.line = smoothed(axis.line, axis.radius);
  }
  sections = centre(axis.line, slicer, kOtherLoop * axis.radius);
  refuseNonTube(axis, sections);

  const auto [first, last] = usableRange(sections, axis.radius);
  const Vec3 start = axis.line.points[first], end = axis.line.points[last];
  axis.line = smoothed(axis.line, axis.radius);
  axis.first = axis.line.nearest(start);
  axis.last = axis.line.nearest(end);
  return axis;
}

}  // namespace halsted::scenes
