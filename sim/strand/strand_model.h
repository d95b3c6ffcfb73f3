#pragma once
/// The strand: suture thread with its needle as one curve with one material coordinate s [m].
///   0 = free tail, L = swage (thread length), L + arc = needle tip.
/// The thread is a rod of nodes (stretch EA, isotropic bending EI, straight at rest); the needle is a rigid arc.
#include <vector>

#include "sim/exchange.h"
#include "sim/params.h"
#include "sim/types.h"

namespace halsted {

struct StrandModel {
  int nodes = 0;                               // thread nodes
  double segment = 0.0;                        // [m] rest length
  double length = 0.0;                         // [m] of the thread: (nodes - 1) * segment
  double radius = 0.0;                         // [m] of the thread
  double axial = 0.0;                          // [N/m] EA / segment
  double bending = 0.0;                        // [N/m] EI / segment^3
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

/// Point and unit tangent (toward the tip) of the needle arc in its frame, at strand coordinate s in [L, L + arc].
void arcAt(const StrandModel&, double s, Vec3& point, Vec3& tangent);

}  // namespace halsted
