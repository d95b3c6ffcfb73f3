#pragma once
/// Every number of a needle in layered tissue that a scene may set. Sources: paper = acupuncture-force-net 2021; physics.md A3, B6, C3.
#include <array>

#include "sim/types.h"

namespace halsted {

inline constexpr int kLayers = 3;              // skin, fat, muscle

enum class NetProfile : std::uint8_t {
  kCone,                                       // the paper: depth falls linearly to nothing; forces far beyond a desktop device
  kInverseDistance                             // Boussinesq's a / r: what an elastic half-space does, and what a device can render
};

struct LayerParams {
  double thickness = 0.8e-3;                   // [m] paper, table 2
  double springStiffness = 160.0;              // [N/m] K of one virtual spring; paper, table 2
  double springLength = 2e-3;                  // [m] L; paper, table 2
  int rings = 8;                               // w, the centre counted; paper, table 2
  double damping = 3000.0;                     // [N s/m^2] d per length of shaft; the paper's number read per millimetre of depth
  double punctureForce = 0.30;                 // [N] 0: the paper's own, from NeedlingParams::coneSlope
  double friction = 25.0;                      // [N/m] Coulomb friction per length of shaft
  double cutForce = 0.05;                      // [N] tip advancing
};

struct NeedlingParams {
  double dt = 1e-3;                            // [s]
  NetProfile profile = NetProfile::kInverseDistance;
  double coneSlope = 0.2;                      // [1] of the dimple's side, for the paper's cone when a layer names no puncture force
  std::array<LayerParams, kLayers> layers{{
      {0.8e-3, 160.0, 2.0e-3, 8, 3000.0, 0.30, 25.0, 0.05},     // skin peak 0.1 to 0.5 N, physics.md D
      {8.4e-3, 80.0, 1.0e-3, 4, 1000.0, 0.04, 3.0, 0.02},       // fat (design)
      {39.0e-3, 230.0, 2.5e-3, 10, 3000.0, 0.15, 6.0, 0.04}}};  // muscle fascia (design)
  double needleRadius = 0.125e-3;              // [m] 0.25 mm needle; physics.md D
  double needleLength = 40e-3;                 // [m] shaft; 25 to 75 mm, physics.md D
  double handleLength = 22e-3, handleRadius = 0.55e-3;   // [m] wound copper wire (design)
  double springbackTime = 0.08;                // [s] from puncture to rest; physics.md A3 f: 50 to 100 ms
  double shaftStiffness = 400.0;               // [N/m] tissue held by the shaft, before it slips (design)
  double staticRatio = 1.3;                    // [1] static over sliding friction (design)
  double weakening = 1.0e-3;                   // [m] of sliding over which static becomes sliding friction (design)
  double stillSpeed = 0.5e-3;                  // [m/s] D / 2 of the modified Karnopp model: below it friction is static (design)
  double tipStiffness = 1500.0;                // [N/m] tissue ahead of the tip before it is cut (design)
  double sideStiffness = 2.0e4;                // [N/m^2] sideways, per length of shaft: about 2 pi G / ln(R / a), G = 15 kPa (design)
  double surfaceGrip = 0.6;                    // [1] friction of the tip on unbroken skin (design)
  double windLinear = 13.1e-6, windCubic = 8.09e-6;   // [N m] 60 and 180 degrees give 0.023 and 0.292 N mm (Han 2015, physics.md C3)
  double windLength = 20e-3;                   // [m] shaft length at which that holds (design)
  double windDamping = 2.0e-6;                 // [N m s/rad] grows with frequency, Han 2015 (design)
  double windLimit = 0.30e-3;                  // [N m] torque at which the shaft slips round (design: just above Han's largest)
  double graspMost = 2.67;                     // [1] pull-out force + 167 % after one-way rotation (Langevin 2001)
  double graspWind = 0.035;                    // [1/rad] tuned: 16 turns one way reach the most
  double graspUnwind = 0.0233;                 // [1/rad] tuned: + 52 % after the same turning back and forth (Langevin 2001)
  double graspTime = 60.0;                     // [s] relaxation (design)
  // A stroke within these counts as one; physics.md C3.
  double liftLeast = 2e-3, liftMost = 10e-3;   // [m] lifting and thrusting
  double twirlLeast = 1.0, twirlMost = 3.5;    // [rad] 60 to 180 degrees, and a tenth more
  double fingerRadius = 8e-3;                  // [m] pressing finger
  double fingerStiffness = 400.0;              // [N/m] 2 a E*, E = 20 kPa in vivo, physics.md D
};

}  // namespace halsted
