#include "sim/strand/strand_model.h"

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

}  // namespace

StrandModel buildStrand(const SimParams& p) {
  check(p);
  StrandModel m;
  const ThreadParams& t = p.thread;
  m.nodes = t.nodes;
  m.segment = t.segmentLength;
  m.length = (t.nodes - 1) * t.segmentLength;
  m.radius = t.radius;
  m.axial = t.axialStiffness / t.segmentLength;
  m.bending = t.bendingStiffness / (t.segmentLength * t.segmentLength * t.segmentLength);
  m.damping = t.damping;
  m.mass.assign(m.nodes, t.linearDensity * t.segmentLength);
  m.mass.front() *= 0.5;
  m.mass.back() *= 0.5;
  m.needle = {p.needle.arcLength / p.needle.arcAngle, p.needle.arcAngle, p.needle.wireRadius};
  buildArc(p.needle.arcAngle, m);
  buildNeedleBody(p, m);
  for (int i = 0; i < kNeedleSamples; ++i) m.sampleCoordinate.push_back(m.length + p.needle.arcLength * i / (kNeedleSamples - 1));
  return m;
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
