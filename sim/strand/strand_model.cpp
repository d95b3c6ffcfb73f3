#include "sim/strand/strand_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/portable_math.h"

namespace halsted {
namespace {

constexpr int kNeedleSamples = 11;

void require(bool ok, const char* message) {
  if (!ok) throw std::invalid_argument(message);
}

void check(const SimParams& p) {
  require(p.thread.nodes >= 8 && p.thread.nodes <= 2000, "thread.nodes must lie between 8 and 2000");
  require(p.thread.segmentLength > 0.0, "thread.segment_length must be positive");
  require(p.thread.radius > 0.0, "thread.radius must be positive");
  require(p.thread.linearDensity > 0.0, "thread.linear_density must be positive");
  require(p.thread.axialStiffness > 0.0, "thread.axial_stiffness must be positive");
  require(p.thread.bendingStiffness >= 0.0, "thread.bending_stiffness must not be negative");
  require(p.thread.yieldMoment >= 0.0, "thread.yield_moment must not be negative");
  const double length = (p.thread.nodes - 1) * p.thread.segmentLength;   // [m]
  const bool fine = p.thread.fineSegment > 0.0;
  require(!fine || (p.thread.fineFrom >= 0.0 && p.thread.fineFrom < p.thread.fineTo && p.thread.fineTo <= length + 1e-9),
          "thread.fine_from and thread.fine_to must name a stretch of the thread");
  require(!fine || p.thread.fineSegment <= p.thread.segmentLength, "thread.fine_segment must not be longer than thread.segment_length");
  require(!fine || (p.thread.fineTo - p.thread.fineFrom) / p.thread.fineSegment <= 2000.0, "thread.fine_segment makes more than 2000 nodes");
  require(p.thread.assist == ThreadAssist::kNone || p.thread.knots, "thread.assist needs thread.knots");
  require(!p.thread.knots || (p.thread.substeps >= 1 && p.thread.substeps <= 20), "thread.substeps must lie between 1 and 20");
  require(p.thread.breakingTension > 0.0, "thread.breaking_tension must be positive");
  require(p.needle.arcLength > 0.0, "needle.arc_length must be positive");
  require(p.needle.arcAngle > 0.5 && p.needle.arcAngle < 5.0, "needle.arc_angle must lie between 0.5 and 5 rad");
  require(p.needle.wireRadius > 0.0, "needle.wire_radius must be positive");
}

/// Unit circle by turning: one short turn, repeated.
void buildArc(double angle, StrandModel& m) {  // [rad]
  const double c = cosineNearZero(angle / StrandModel::kArcTable), s = sineNearZero(angle / StrandModel::kArcTable);   // [1]
  Vec3 radial = Vec3::UnitX();
  for (int i = 0; i <= StrandModel::kArcTable; ++i) {
    m.arcPoint.push_back(m.needle.radius * radial);
    m.arcTangent.push_back(Vec3(-radial.y(), radial.x(), 0.0));
    radial = Vec3(c * radial.x() - s * radial.y(), s * radial.x() + c * radial.y(), 0.0);
  }
}

/// Mass, centre and inertia of a thin arc by summation over the table (load time).
void buildNeedleBody(const SimParams& p, StrandModel& m) {
  const double area = kPi * p.needle.wireRadius * p.needle.wireRadius;   // [m^2]
  m.needleMass = p.needle.density * area * p.needle.arcLength;
  const double piece = m.needleMass / StrandModel::kArcTable;                            // [kg]
  for (int i = 0; i < StrandModel::kArcTable; ++i) m.needleCentre += 0.5 * (m.arcPoint[i] + m.arcPoint[i + 1]);
  m.needleCentre /= StrandModel::kArcTable;
  for (int i = 0; i < StrandModel::kArcTable; ++i) {
    const Vec3 r = 0.5 * (m.arcPoint[i] + m.arcPoint[i + 1]) - m.needleCentre;
    m.needleInertia += piece * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  }
  // A thin wire has no inertia about its own axis; the floor keeps the matrix well conditioned.
  m.needleInertia += m.needleMass * p.needle.wireRadius * p.needle.wireRadius * Mat3::Identity();
}

/// Coarse, fine, coarse: the fine stretch takes the place of whole coarse segments.
void layOutRegions(const ThreadParams& t, StrandModel& m) {
  const int coarse = t.nodes - 1;
  m.length = coarse * t.segmentLength;
  m.nodes = t.nodes;
  m.finest = t.segmentLength;
  if (!(t.fineSegment > 0.0)) { m.regions = {{0.0, 0, t.segmentLength}}; return; }
  const int first = std::clamp(static_cast<int>(std::lround(t.fineFrom / t.segmentLength)), 0, coarse - 1);
  const int last = std::clamp(static_cast<int>(std::lround(t.fineTo / t.segmentLength)), first + 1, coarse);
  const double from = first * t.segmentLength, to = last * t.segmentLength;   // [m]
  const int fine = static_cast<int>(std::lround((to - from) / t.fineSegment));
  m.finest = (to - from) / fine;
  if (first > 0) m.regions.push_back({0.0, 0, t.segmentLength});
  m.regions.push_back({from, first, m.finest});
  if (last < coarse) m.regions.push_back({to, first + fine, t.segmentLength});
  m.nodes = first + fine + coarse - last + 1;
}

/// Energy of a discrete rod's curvature between unequal segments (Bergou et al. 2006).
NodeBend bendBetween(double before, double after, const ThreadParams& t) {   // [m], [m]
  const double mean = 0.5 * (before + after);  // [m]
  const double yield = t.bendingStiffness > 0.0 ? t.yieldMoment / t.bendingStiffness : 0.0;   // [1/m] curvature
  return {t.bendingStiffness / (mean * mean * mean), {mean / before, -(mean / before + mean / after), mean / after}, yield * mean * mean};
}

void layOutNodes(const ThreadParams& t, StrandModel& m) {
  for (std::size_t r = 0; r < m.regions.size(); ++r) {
    const int end = r + 1 < m.regions.size() ? m.regions[r + 1].node : m.nodes - 1;
    for (int i = m.regions[r].node; i < end; ++i) m.rest.push_back(m.regions[r].segment);
  }
  for (int i = 0; i < m.nodes; ++i) m.place.push_back(coordinateAt(m, i, 0.0));
  for (double rest : m.rest) m.axialOf.push_back(t.axialStiffness / rest);
  for (int i = 1; i + 1 < m.nodes; ++i) m.bend.push_back(bendBetween(m.rest[i - 1], m.rest[i], t));
  m.mass.push_back(t.linearDensity * (0.5 * m.rest.front()));
  for (int i = 1; i + 1 < m.nodes; ++i) m.mass.push_back(t.linearDensity * (0.5 * (m.rest[i - 1] + m.rest[i])));
  m.mass.push_back(t.linearDensity * (0.5 * m.rest.back()));
}

}  // namespace

StrandModel buildStrand(const SimParams& p) {
  check(p);
  StrandModel m;
  const ThreadParams& t = p.thread;
  m.segment = t.segmentLength;
  m.radius = t.radius;
  m.damping = t.damping;
  m.takesSet = t.knots && t.yieldMoment > 0.0 && t.bendingStiffness > 0.0;
  layOutRegions(t, m);
  layOutNodes(t, m);
  m.needle = {p.needle.arcLength / p.needle.arcAngle, p.needle.arcAngle, p.needle.wireRadius};
  buildArc(p.needle.arcAngle, m);
  buildNeedleBody(p, m);
  for (int i = 0; i < kNeedleSamples; ++i) m.sampleCoordinate.push_back(m.length + p.needle.arcLength * i / (kNeedleSamples - 1));
  return m;
}

double coordinateAt(const StrandModel& m, int node, double share) {
  std::size_t r = m.regions.size() - 1;
  while (r > 0 && node < m.regions[r].node) --r;
  return m.regions[r].from + (node - m.regions[r].node + share) * m.regions[r].segment;
}

double lengthAfter(const StrandModel& m, int node) {
  double length = 0.0;
  int end = m.nodes - 1;
  for (std::size_t r = m.regions.size(); r-- > 0 && node < end; end = m.regions[r].node)
    length += m.regions[r].segment * (end - std::max(node, m.regions[r].node));
  return length;
}

void arcAt(const StrandModel& m, double s, Vec3& point, Vec3& tangent) {
  const double arc = m.needle.radius * m.needle.angle;
  double u = (s - m.length) / arc * StrandModel::kArcTable;
  u = u < 0.0 ? 0.0 : (u > StrandModel::kArcTable ? StrandModel::kArcTable : u);
  int i = static_cast<int>(u);
  if (i >= StrandModel::kArcTable) i = StrandModel::kArcTable - 1;
  const double a = u - i;
  point = (1.0 - a) * m.arcPoint[i] + a * m.arcPoint[i + 1];
  tangent = ((1.0 - a) * m.arcTangent[i] + a * m.arcTangent[i + 1]).normalized();
}

}  // namespace halsted
