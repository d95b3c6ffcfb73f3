#include "render/tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halsted::render {
namespace {

constexpr int kPerSegment = 3;               // drawn pieces between two nodes
constexpr double kTurn = 2.0 * std::numbers::pi;   // [rad]

/// Catmull and Rom 1974, uniform, tension one half: passes through p1 at t = 0 and p2 at t = 1.
Vec3 spline(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3, double t) {   // [m], t [1]
  return 0.5 * (2.0 * p1 + t * ((p2 - p0) + t * ((2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) + t * (3.0 * (p1 - p2) + p3 - p0))));
}

}  // namespace

Vec3 anyAcross(const Vec3& direction) {
  const Vec3 other = std::abs(direction.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX();
  return direction.cross(other).normalized();
}

void makeIndices(int rings, Tube& tube) {
  constexpr int kRow = Tube::kSides + 1;
  tube.vertices.resize(static_cast<std::size_t>(rings) * kRow);
  for (int i = 0; i + 1 < rings; ++i)
    for (int k = 0; k < Tube::kSides; ++k) {
      const auto at = [&](int di, int dk) { return static_cast<std::uint32_t>((i + di) * kRow + k + dk); };
      tube.indices.insert(tube.indices.end(), {at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0)});
    }
}

void writeRing(const RingFrame& ring, int index, Tube& tube) {
  constexpr int kRow = Tube::kSides + 1;
  for (int k = 0; k < kRow; ++k) {
    const double turn = static_cast<double>(k) / Tube::kSides;                    // [1]
    const double angle = kTurn * turn + ring.twist;                               // [rad]
    const Vec3 n = std::cos(angle) * ring.first + std::sin(angle) * ring.second;
    TubeVertex& v = tube.vertices[static_cast<std::size_t>(index) * kRow + k];
    for (int c = 0; c < 3; ++c) {
      v.centre[c] = static_cast<float>(ring.centre[c]);
      v.normal[c] = static_cast<float>(n[c]);
    }
    v.radius = static_cast<float>(ring.radius);
    v.along = static_cast<float>(ring.along);
    v.turn = static_cast<float>(turn);
  }
}

Tube makeThread(int nodes) {
  Tube tube;
  if (nodes >= 2) makeIndices((nodes - 1) * kPerSegment + 1, tube);
  return tube;
}

std::vector<std::uint32_t> threadShadowIndices(int nodes) {
  constexpr int kRow = Tube::kSides + 1;
  std::vector<std::uint32_t> indices;
  for (int i = 0; i + 1 < nodes; ++i)
    for (int k = 0; k < Tube::kSides; k += 2) {
      const auto at = [&](int di, int dk) { return static_cast<std::uint32_t>((i + di) * kPerSegment * kRow + k + dk); };
      indices.insert(indices.end(), {at(0, 0), at(0, 2), at(1, 2), at(0, 0), at(1, 2), at(1, 0)});
    }
  return indices;
}

namespace {

/// Thread does not stretch: nodes much farther apart than those beside them have a cut between them, and nothing is drawn there.
bool isGap(std::span<const Vec3> nodes, int segment) {
  constexpr double kParted = 3.0;            // [1]
  const auto length = [&](int i) { return i >= 0 && i + 1 < static_cast<int>(nodes.size()) ? (nodes[i + 1] - nodes[i]).norm() : 0.0; };   // [m]
  const double beside = std::max(length(segment - 1), length(segment + 1));      // [m]
  return segment >= 0 && beside > 0.0 && length(segment) > kParted * beside;
}

/// Rings along a wire: where it is parted, how it is turned and how thick it is at a ring is the caller's.
struct Wire {
  std::span<const Vec3> nodes;                 // [m]
  std::span<const double> twist;               // [rad]
  std::span<const int> knots;
  double radius = 0.0;                         // [m]
  bool mayPart = true;
};

/// Two strands wound about each other, drawn as one bead.
double thickness(const Wire& wire, double at) {   // [m] at a node, or between two
  constexpr double kKnot = 2.3, kReach = 0.75;    // [1] of the thread's radius; nodes to either side
  double most = 1.0;                           // [1]
  for (int knot : wire.knots) {
    const double off = std::abs(at - knot) / kReach;   // [1]
    if (off < 1.0) most = std::max(most, 1.0 + (kKnot - 1.0) * std::sqrt(1.0 - off * off));
  }
  return most * wire.radius;
}

void layRings(const Wire& wire, Tube& tube) {
  const int count = static_cast<int>(wire.nodes.size()), rings = (count - 1) * kPerSegment + 1;
  if (count < 2 || tube.vertices.size() != static_cast<std::size_t>(rings) * (Tube::kSides + 1)) return;
  const auto node = [&](int i) -> const Vec3& { return wire.nodes[std::clamp(i, 0, count - 1)]; };
  const auto angle = [&](int i) { return i < static_cast<int>(wire.twist.size()) ? wire.twist[i] : 0.0; };
  const auto gap = [&](int i) { return wire.mayPart && isGap(wire.nodes, i); };
  const auto place = [&](int ring) {
    const int i = std::min(ring / kPerSegment, count - 2);
    const double t = static_cast<double>(ring) / kPerSegment - i;                 // [1]
    if (gap(i) && t > 0.0) return t < 0.5 ? node(i) : node(i + 1);
    return spline(gap(i - 1) ? node(i) : node(i - 1), node(i), node(i + 1), gap(i + 1) ? node(i + 1) : node(i + 2), t);
  };
  RingFrame frame{place(0), Vec3::UnitX(), Vec3::UnitY(), wire.radius, 0.0, 0.0};
  Vec3 ahead = place(1), direction = (ahead - frame.centre).normalized();
  frame.first = anyAcross(direction);
  for (int ring = 0; ring < rings; ++ring) {
    const Vec3 behind = frame.centre;
    frame.centre = place(ring);
    frame.along += (frame.centre - behind).norm();
    ahead = place(std::min(ring + 1, rings - 1));
    const Vec3 chord = ahead - behind;                                            // [m]
    if (chord.squaredNorm() > 0.0) direction = chord.normalized();
    const Vec3 across = frame.first - direction * direction.dot(frame.first);     // drop what the bend took
    frame.first = across.squaredNorm() > 1e-12 ? Vec3(across.normalized()) : anyAcross(direction);
    frame.second = direction.cross(frame.first);
    const int i = std::min(ring / kPerSegment, count - 2);
    const double t = static_cast<double>(ring) / kPerSegment - i;                 // [1]
    frame.twist = (1.0 - t) * angle(i) + t * angle(i + 1);
    const bool parted = gap(i) || (t == 0.0 && gap(i - 1));                       // both ends come to a point, or their shadow would lead across
    frame.radius = parted ? 0.0 : thickness(wire, i + t);
    writeRing(frame, ring, tube);
  }
}

}  // namespace

void updateThread(const std::vector<Vec3>& nodes, const std::vector<double>& twist, double radius, Tube& tube) {
  layRings({nodes, twist, {}, radius, true}, tube);
}

void updateTiedThread(std::span<const Vec3> nodes, std::span<const int> knots, double radius, Tube& tube) {
  layRings({nodes, {}, knots, radius, false}, tube);
}

Tube makeNeedle(const NeedleShape& needle) {
  constexpr int kRings = 73;
  constexpr double kSwage = 0.055, kTaper = 0.80;   // [1] shares of the arc: the crimped barrel, where the point begins
  Tube tube;
  makeIndices(kRings, tube);
  for (int i = 0; i < kRings; ++i) {
    const double s = static_cast<double>(i) / (kRings - 1), t = s * needle.angle;   // [1], [rad]
    const Vec3 out(std::cos(t), std::sin(t), 0.0);
    double thickness = 1.0;                                                        // [1] of the wire
    if (s < kSwage) thickness = 1.12 - 0.5 * std::exp(-60.0 * s);
    if (s > kTaper) thickness = std::max(0.03, std::pow((1.0 - s) / (1.0 - kTaper), 0.75));
    writeRing({needle.radius * out, -out, Vec3::UnitZ(), thickness * needle.wireRadius, s * needle.angle * needle.radius, 0.0}, i, tube);
  }
  return tube;
}

}  // namespace halsted::render
