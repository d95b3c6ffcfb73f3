#include "scenes/tube.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/input_text.h"
#include "scenes/scene.h"
#include "scenes/tube_axis.h"
#include "scenes/tube_grid.h"
#include "scenes/tube_segment.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

constexpr int kOversample = 3;               // rays and sections per grid point, of which the median is taken
constexpr double kMostMissing = 0.2;         // [1] of the rays of a segment
constexpr double kOtherLoop = 2.2;           // [1] of the median radius: farther walls are another loop's
constexpr double kLeastAdvance = 0.2;        // [1] of the row spacing that the inside of a bend must keep
constexpr int kStraightenRounds = 8;
constexpr double kStraightenGrowth = 1.4;    // [1] window of the smoothing from round to round
constexpr double kTrialStep = 4e-3;          // [m] between the stretches tried by default
constexpr double kLongestStretch = 0.5;      // [m]
constexpr int kRimRays = 36;
constexpr double kRoundWeight = 0.4;         // [1] of the rim's roundness against its straightness; tuned on both real colons
constexpr double kSteepest = 1.0;            // [1] radius change per distance along the wall, 45 degrees
constexpr int kSoftenRounds = 200;

/// From the open rim to the fixed end, along the axis; rim > farEnd runs against it.
struct Stretch {
  double rim = 0.0, farEnd = 0.0;            // [m]
  double at(double share) const { return rim + share * (farEnd - rim); }  // share [1]
  double length() const { return std::max(rim, farEnd) - std::min(rim, farEnd); }
};

std::string millimetres(double metres) { return plainNumber(metres * 1e3) + " mm"; }

/// How well a stretch suits a rim that is easy to reach: the tube leaves it at a right angle, straight, and the rim is round.
double fitness(const TubeAxis& axis, const TubeSlicer& slicer, const Stretch& stretch) {  // [1]
  const Vec3 chord = axis.line.at(stretch.farEnd) - axis.line.at(stretch.rim);
  const Vec3 tangent = axis.line.tangent(stretch.rim) * (stretch.farEnd > stretch.rim ? 1.0 : -1.0);
  Section rim = slicer.cut(planeAt(axis.line, stretch.rim), kRimRays);
  rim.dropBeyond(kOtherLoop * axis.radius);
  if (rim.missing() > 0) return 0.0;
  const auto [least, most] = std::minmax_element(rim.radius.begin(), rim.radius.end());
  return tangent.dot(chord.normalized()) * chord.norm() / stretch.length() + kRoundWeight * *least / *most;
}

/// The fittest one in either direction, the first among equals.
Stretch fittest(const TubeAxis& axis, const TubeSlicer& slicer, double length) {  // length [m]
  Stretch best{axis.first, axis.first + length};
  double highest = -10.0;  // [1]
  for (double from = axis.first; from + length <= axis.last; from += kTrialStep) {
    for (const Stretch& trial : {Stretch{from, from + length}, Stretch{from + length, from}}) {
      const double value = fitness(axis, slicer, trial);  // [1]
      if (value <= highest + 1e-6) continue;
      highest = value;
      best = trial;
    }
  }
  return best;
}

Stretch chooseStretch(const TubeAxis& axis, const TubeSlicer& slicer, const AnatomyParams& anatomy) {
  const TubeSegment segment = parseSegment(anatomy.segment);
  const double usable = axis.last - axis.first, length = anatomy.length;  // [m]
  const auto place = [&](double share) { return axis.first + share * usable; };
  if (segment.kind != TubeSegment::Kind::kRange && usable < length)
    throw InputError("the tube is usable over " + millimetres(usable) + " only, anatomy.length asks for " + millimetres(length));
  switch (segment.kind) {
    case TubeSegment::Kind::kBest: return fittest(axis, slicer, length);
    case TubeSegment::Kind::kStart: return {axis.first, axis.first + length};
    case TubeSegment::Kind::kEnd: return {axis.last, axis.last - length};
    case TubeSegment::Kind::kAt:
      if (place(segment.rim) + length > axis.last)
        throw InputError("anatomy.segment " + anatomy.segment + " leaves the tube: " + millimetres(length) +
                         " fit in up to " + plainNumber((usable - length) / usable));
      return {place(segment.rim), place(segment.rim) + length};
    default: break;
  }
  const Stretch range{place(segment.rim), place(segment.farEnd)};
  if (range.length() < 0.5 * axis.radius || range.length() > kLongestStretch)
    throw InputError("anatomy.segment " + anatomy.segment + " is " + millimetres(range.length()) + " long, must be " +
                     millimetres(0.5 * axis.radius) + " to " + millimetres(kLongestStretch));
  return range;
}

/// Finely sampled stretch: planes and distances, holes not yet filled.
struct FineSections {
  std::vector<SectionFrame> frames;
  std::vector<Section> sections;
};

/// Normals point out of the rim, toward the surgeon, so that rays run counter-clockwise as the surgeon sees them.
FineSections measure(const TubeSlicer& slicer, const TubeAxis& axis, const Stretch& stretch, const AnatomyParams& anatomy) {
  FineSections fine;
  const int rows = kOversample * (anatomy.along - 1) + 1;
  for (int row = 0; row < rows; ++row) {
    const double distance = stretch.at(static_cast<double>(row) / (rows - 1));  // [m]
    const Vec3 tangent = axis.line.tangent(distance);
    const Vec3 normal = stretch.farEnd > stretch.rim ? Vec3(-tangent) : tangent;
    const Vec3 centre = axis.line.at(distance);
    fine.frames.push_back(row == 0 ? uprightFrame(centre, normal) : transported(fine.frames.back(), centre, normal));
    fine.sections.push_back(slicer.cut(fine.frames.back(), kOversample * anatomy.around));
    fine.sections.back().dropBeyond(kOtherLoop * axis.radius);
  }
  return fine;
}

/// Round each section first, then along the tube for sections without any wall.
void closeHoles(FineSections& fine) {
  const int rows = static_cast<int>(fine.sections.size()), rays = static_cast<int>(fine.sections[0].radius.size());
  int missing = 0;
  for (const Section& section : fine.sections) missing += section.missing();
  if (missing > kMostMissing * rows * rays)
    throw InputError(plainNumber(100.0 * missing / (rows * rays)) + " % of the segment's wall is missing (" + std::to_string(missing) +
                     " of " + std::to_string(rows * rays) + " rays from its middle line meet nothing), at most " +
                     plainNumber(100.0 * kMostMissing) + " % is closed");
  std::vector<char> empty(fine.sections.size(), 0);
  for (int row = 0; row < rows; ++row) {
    empty[row] = fine.sections[row].missing() == rays;
    if (!empty[row]) fine.sections[row].fill();
  }
  for (int row = 0; row < rows; ++row) {
    if (!empty[row]) continue;
    int before = row, after = row;
    while (before >= 0 && empty[before]) --before;
    while (after < rows && empty[after]) ++after;
    if (before < 0) before = after;
    if (after >= rows) after = before;
    const double share = after > before ? static_cast<double>(row - before) / (after - before) : 0.0;  // [1]
    for (int i = 0; i < rays; ++i)
      fine.sections[row].radius[i] = (1.0 - share) * fine.sections[before].radius[i] + share * fine.sections[after].radius[i];
  }
}

/// Median of the fine rays round each grid point: one stray ray through a fold does not make a spike.
std::vector<double> gridRadii(const FineSections& fine, const AnatomyParams& anatomy) {  // [m]
  const int rows = static_cast<int>(fine.sections.size()), rays = static_cast<int>(fine.sections[0].radius.size());
  std::vector<double> radii;  // [m]
  for (int row = 0; row < anatomy.along; ++row)
    for (int column = 0; column < anatomy.around; ++column) {
      std::vector<double> around;  // [m]
      for (int dr = -1; dr <= 1; ++dr)
        for (int dc = -1; dc <= 1; ++dc) {
          const int fineRow = std::clamp(kOversample * row + dr, 0, rows - 1);
          around.push_back(fine.sections[fineRow].radius[(kOversample * column + dc + rays) % rays]);
        }
      std::nth_element(around.begin(), around.begin() + 4, around.end());
      radii.push_back(around[4]);
    }
  return radii;
}

double halfSmoothed(const TubeGrid& grid, const std::vector<double>& radii, int row, int column) {  // radii [m]
  const double sum = radii[grid.at(row, column - 1)] + radii[grid.at(row, column + 1)] +                 // [m]
                     radii[grid.at(std::max(row - 1, 0), column)] + radii[grid.at(std::min(row + 1, grid.along - 1), column)];
  return 0.5 * radii[grid.at(row, column)] + 0.125 * sum;
}

/// Steeper than 45 degrees to a neighbour: a fold that hangs over as seen from the middle line, which one radius a ray cannot hold.
bool isSteep(const TubeGrid& grid, const std::vector<double>& radii, int row, int column, double rowSpacing) {  // [m]
  const double r = radii[grid.at(row, column)];  // [m]
  const double across = kSteepest * r * 2.0 * kPi / grid.around, down = kSteepest * rowSpacing;  // [m]
  return std::abs(radii[grid.at(row, column - 1)] - r) > across || std::abs(radii[grid.at(row, column + 1)] - r) > across ||
         std::abs(radii[grid.at(std::max(row - 1, 0), column)] - r) > down ||
         std::abs(radii[grid.at(std::min(row + 1, grid.along - 1), column)] - r) > down;
}

/// Once everywhere, which keeps the haustra and takes the scanner's steps; then only where it is steep.
void smoothRadii(const TubeGrid& grid, std::vector<double>& radii, double rowSpacing) {  // radii, rowSpacing [m]
  for (int round = 0; round < kSoftenRounds; ++round) {
    const std::vector<double> before = radii;  // [m]
    bool changed = false;
    for (int row = 0; row < grid.along; ++row)
      for (int column = 0; column < grid.around; ++column) {
        if (round > 0 && !isSteep(grid, before, row, column, rowSpacing)) continue;
        radii[grid.at(row, column)] = halfSmoothed(grid, before, row, column);
        changed = true;
      }
    if (!changed) return;
  }
}

Vec3 onRay(const SectionFrame& frame, double angle, double radius) {  // angle [rad], radius [m]
  return frame.centre + radius * (cosine(angle) * frame.right + sine(angle) * frame.up);
}

TubeGrid gridOf(const FineSections& fine, const Stretch& stretch, const AnatomyParams& anatomy) {
  TubeGrid grid;
  grid.around = anatomy.around;
  grid.along = anatomy.along;
  std::vector<double> radii = gridRadii(fine, anatomy);  // [m]
  smoothRadii(grid, radii, stretch.length() / (grid.along - 1));
  for (int row = 0; row < grid.along; ++row) {
    const SectionFrame& frame = fine.frames[kOversample * row];
    grid.axis.push_back(frame.centre);
    grid.depth.push_back(stretch.length() * row / (grid.along - 1));
    for (int column = 0; column < grid.around; ++column)
      grid.outer.push_back(onRay(frame, 2.0 * kPi * column / grid.around, radii[grid.at(row, column)]));
  }
  return grid;
}

/// Sections of a bend meet on its inside when it is sharper than the tube is wide.
bool advancesEverywhere(const TubeGrid& grid) {
  for (int row = 0; row + 1 < grid.along; ++row) {
    const Vec3 step = grid.axis[row + 1] - grid.axis[row];
    for (int column = 0; column < grid.around; ++column) {
      const Vec3 advance = grid.outer[grid.at(row + 1, column)] - grid.outer[grid.at(row, column)];
      if (advance.dot(step) < kLeastAdvance * step.squaredNorm()) return false;
    }
  }
  return true;
}

/// Rim's centre to the origin, its normal to +z, its up to +y.
void placeRim(const SectionFrame& rim, TubeGrid& grid) {
  Vec3 centre = Vec3::Zero();
  for (int column = 0; column < grid.around; ++column) centre += grid.outer[grid.at(0, column)] / grid.around;
  const auto moved = [&](const Vec3& p) {
    return Vec3((p - centre).dot(rim.right), (p - centre).dot(rim.up), (p - centre).dot(rim.normal));
  };
  for (Vec3& p : grid.outer) p = moved(p);
  for (Vec3& p : grid.axis) p = moved(p);
}

/// A smoother line through the same stretch: its ends stay where they were in the body.
void straighten(TubeAxis& axis, Stretch& stretch, double window) {  // [m]
  const Vec3 rim = axis.line.at(stretch.rim), farEnd = axis.line.at(stretch.farEnd);
  axis.line = smoothed(axis.line, window);
  stretch = {axis.line.nearest(rim), axis.line.nearest(farEnd)};
}

}  // namespace

TetMesh tubeSegment(const Surface& surface, const AnatomyParams& anatomy) {
  const Surface part = largestPart(surface);
  const TubeSlicer slicer(part, 2.0 * anatomy.wall);
  TubeAxis axis = tubeAxis(part, slicer);
  Stretch stretch = chooseStretch(axis, slicer, anatomy);
  double window = axis.radius;  // [m]
  for (int round = 0; round < kStraightenRounds; ++round) {
    FineSections fine = measure(slicer, axis, stretch, anatomy);
    closeHoles(fine);
    TubeGrid grid = gridOf(fine, stretch, anatomy);
    if (advancesEverywhere(grid)) {
      placeRim(fine.frames[0], grid);
      return wallMesh(grid, anatomy.wall);
    }
    window *= kStraightenGrowth;
    straighten(axis, stretch, window);
  }
  throw InputError("the segment bends more sharply than it is wide; choose another anatomy.segment");
}

}  // namespace halsted::scenes
