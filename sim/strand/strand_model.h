#pragma once
/// The strand: suture thread with its needle as one curve with one material coordinate s [m].
///   0 = free tail, L = swage (thread length), L + arc = needle tip.
/// The thread is a rod of nodes (stretch EA, isotropic bending EI, straight at rest); the needle is a rigid arc.
#include <array>
#include <vector>

#include "sim/exchange.h"
#include "sim/params.h"
#include "sim/types.h"

namespace halsted {

/// A stretch of thread with segments of one length.
struct StrandRegion {
  double from = 0.0;                           // [m] coordinate where it begins
  int node = 0;                                // its first
  double segment = 0.0;                        // [m]
};

/// Bending about one node: energy = stiffness / 2 |w0 x0 + w1 x1 + w2 x2|^2 over it and its neighbours; 1, -2, 1 between equal segments.
struct NodeBend {
  double stiffness = 0.0;                      // [N/m] EI / mean segment^3
  std::array<double, 3> weight{};              // [1]
  double yield = 0.0;                          // [m] of w0 x0 + w1 x1 + w2 x2 at the yield moment; beyond, the thread takes a set
};

struct StrandModel {
  int nodes = 0;                               // thread nodes
  double segment = 0.0;                        // [m] rest length outside the fine stretch
  double finest = 0.0;                         // [m] shortest rest length
  double length = 0.0;                         // [m] of the thread
  double radius = 0.0;                         // [m] of the thread
  std::vector<StrandRegion> regions;           // in order; one unless there is a fine stretch
  std::vector<double> place;                   // [m] coordinate of each node
  std::vector<double> rest, axialOf;           // [m], [N/m] of each segment
  std::vector<NodeBend> bend;                  // of each node but the two ends, from node 1
  bool takesSet = false;                       // it has a yield moment
  double damping = 0.0;                        // [1/s]
  std::vector<double> mass;                    // [kg] per node
  NeedleShape needle;
  double needleMass = 0.0;                     // [kg]
  Vec3 needleCentre = Vec3::Zero();            // [m] centre of mass in the needle frame
  Mat3 needleInertia = Mat3::Zero();           // [kg m^2] about the centre of mass, needle frame
  // Samples of the needle for contact, tip last. Sines and cosines are tabulated at load time: none are taken inside a step.
  std::vector<double> sampleCoordinate;        // [m] strand coordinate
  static constexpr int kArcTable = 512;
  std::vector<Vec3> arcPoint, arcTangent;      // needle frame, kArcTable + 1 entries over the arc
};

StrandModel buildStrand(const SimParams&);

inline double tipCoordinate(const StrandModel& m) { return m.length + m.needle.radius * m.needle.angle; }   // [m]

/// Where a coordinate lies: between `node` and the next, this share of the way.
struct ThreadSpot {
  int node = 0;
  double fraction = 0.0;                       // [1]
};
inline std::size_t regionAt(const StrandModel& m, double s) {   // [m]; which of `regions` a coordinate lies in, or beside
  std::size_t r = m.regions.size() - 1;
  while (r > 0 && s < m.regions[r].from) --r;
  return r;
}

/// Clamped to the thread. Here, as every hole and every link asks for a dozen of them a step.
inline ThreadSpot threadSpot(const StrandModel& m, double s) {   // [m]
  const std::size_t r = regionAt(m, s);
  const StrandRegion& region = m.regions[r];
  const int last = (r + 1 < m.regions.size() ? m.regions[r + 1].node : m.nodes - 1) - region.node - 1;
  double u = (s - region.from) / region.segment;
  u = u < 0.0 ? 0.0 : u;
  int node = static_cast<int>(u);
  if (node > last) node = last;
  const double fraction = u - node;   // [1]
  return {region.node + node, fraction > 1.0 ? 1.0 : fraction};
}

/// Rest length of the thread between a node and the swage.  [m]
double lengthAfter(const StrandModel&, int node);

/// Coordinate of the place `share` [1] of the way from a node to the next.  [m]
double coordinateAt(const StrandModel&, int node, double share);
/// Rest length of the segments about a coordinate; that of the last on the needle.  [m]
inline double segmentAt(const StrandModel& m, double s) { return m.regions[regionAt(m, s)].segment; }   // [m]

/// Point and unit tangent (toward the tip) of the needle arc in its frame, at strand coordinate s in [L, L + arc].
void arcAt(const StrandModel&, double s, Vec3& point, Vec3& tangent);

}  // namespace halsted
