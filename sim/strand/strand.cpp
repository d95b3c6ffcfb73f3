#include "sim/strand/strand.h"

#include <algorithm>

namespace halsted {
StrandWork prepareWork(const StrandModel& m) {
  StrandWork w;
  w.matrix.resize(3 * m.nodes + 6);
  w.rhs.resize(3 * m.nodes + 6 + 3 * kHands);
  w.load.resize(w.rhs.size());
  w.iterate.resize(m.nodes);
  w.inertial.resize(m.nodes);
  return w;
}

StrandState restState(const StrandModel& m, const Pose& needle) {
  StrandState s;
  s.position.resize(m.nodes);
  s.velocity.resize(m.nodes);
  s.tension.resize(m.nodes - 1);
  s.nearVertex.resize(m.nodes + m.sampleCoordinate.size());
  s.otherVertex.resize(s.nearVertex.size());
  layAtRest(m, needle, s);
  return s;
}

void layAtRest(const StrandModel& m, const Pose& needle, StrandState& s) {
  s.needle = needle;
  s.needleVelocity = s.needleSpin = Vec3::Zero();
  const Vec3 swage = needle.apply(m.arcPoint.front());
  for (int i = 0; i < m.nodes; ++i) s.position[i] = swage - Vec3(0.0, lengthAfter(m, i), 0.0);
  std::fill(s.velocity.begin(), s.velocity.end(), Vec3::Zero());
  std::fill(s.tension.begin(), s.tension.end(), 0.0);
  std::fill(s.nearVertex.begin(), s.nearVertex.end(), 0);
  std::fill(s.otherVertex.begin(), s.otherVertex.end(), -1);
  std::fill(s.comesThrough.begin(), s.comesThrough.end(), 0);
  s.holes.fill(Hole{});
  s.contacts.fill(StrandContact{});
  s.holeCount = s.contactCount = 0;
}

bool addLink(StrandWork& w, const StrandLink& link) {
  if (w.linkCount >= StrandWork::kMaxLinks) return false;
  w.links[w.linkCount++] = link;
  return true;
}

namespace {

Vec3 threadPoint(const StrandModel& m, const StrandState& s, double coordinate) {   // [m]
  const ThreadSpot spot = threadSpot(m, coordinate);
  return (1.0 - spot.fraction) * s.position[spot.node] + spot.fraction * s.position[spot.node + 1];
}

}  // namespace

Vec3 strandPoint(const StrandModel& m, const StrandState& s, double coordinate) {
  if (coordinate > m.length) {
    Vec3 point, tangent;
    arcAt(m, coordinate, point, tangent);
    return s.needle.apply(point);
  }
  return threadPoint(m, s, coordinate);
}

Vec3 strandTangent(const StrandModel& m, const StrandState& s, double coordinate) {
  if (coordinate > m.length) {
    Vec3 point, tangent;
    arcAt(m, coordinate, point, tangent);
    return s.needle.orientation * tangent;
  }
  // Over a segment's length about the point: the direction of one segment alone would jump as a hole slides past a node.
  const double segment = segmentAt(m, coordinate);             // [m]
  const double from = coordinate - 0.5 * segment, to = coordinate + 0.5 * segment;         // [m]
  const Vec3 d = threadPoint(m, s, to > m.length ? m.length : to) - threadPoint(m, s, from);
  const double length = d.norm();
  return length > 0.0 ? Vec3(d / length) : Vec3::UnitX();
}

Vec3 strandVelocity(const StrandModel& m, const StrandState& s, double coordinate) {
  if (coordinate > m.length) {
    Vec3 point, tangent;
    arcAt(m, coordinate, point, tangent);
    return s.needleVelocity + s.needleSpin.cross(s.needle.orientation * (point - m.needleCentre));
  }
  const ThreadSpot spot = threadSpot(m, coordinate);
  return (1.0 - spot.fraction) * s.velocity[spot.node] + spot.fraction * s.velocity[spot.node + 1];
}

double strandTension(const StrandModel& m, const StrandState& s, double coordinate, int side) {
  if (coordinate > m.length) return 0.0;
  int segment = threadSpot(m, coordinate).node + (side < 0 ? -1 : 1);
  segment = segment < 0 ? 0 : (segment > m.nodes - 2 ? m.nodes - 2 : segment);
  return s.tension[segment] > 0.0 ? s.tension[segment] : 0.0;
}

}  // namespace halsted
