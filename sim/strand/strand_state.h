#pragma once
/// What changes of thread and needle. Part of `State`; written by sim/strand and sim/suture.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/types.h"

namespace halsted {

/// A point of the tissue that the strand passes through. Kept sorted by `coordinate`, tail first.
enum class HoleRole : std::int32_t { kEntry, kExit, kPassed, kTip };   // kPassed: an exit that the whole needle has left behind

struct Hole {
  std::int32_t tet = -1;
  std::array<double, 4> weight{};              // [1] barycentric in the tet
  double coordinate = 0.0;                     // [m] material coordinate of the strand at the hole
  Vec3 force = Vec3::Zero();                   // [N] on the strand
  std::int32_t slip = 0;                       // [1] 0 the strand sticks; +1 it slides toward larger coordinates; -1 toward smaller
  std::int32_t bite = -1;                      // which bite it belongs to
  std::int32_t role = 0;                       // HoleRole
  double entryCosine = 0.0;                    // [1] of an entry: between the needle's tip and the inward normal as it went in
};

/// A unilateral contact of a strand sample with tissue, a tool or a rod; kept from step to step.
struct StrandContact {
  std::int32_t sample = -1;                    // thread node, nodes + needle sample, or all of these + the node before which it lies half-way
  std::int32_t feature = -1;                   // surface triangle, or triangles + solid index
  double normalForce = 0.0;                    // [N]
  Vec3 force = Vec3::Zero();                   // [N] on the strand
  std::array<double, 3> weight{};              // [1] barycentric in the triangle (tissue only)
};

struct StrandState {
  static constexpr int kMaxHoles = 128, kMaxContacts = 256;
  std::vector<Vec3> position, velocity;        // [m], [m/s] thread nodes, tail first, swage last
  std::vector<double> tension;                 // [N] per segment, negative when pushed
  Pose needle;
  Vec3 needleVelocity = Vec3::Zero();          // [m/s] of the centre of mass
  Vec3 needleSpin = Vec3::Zero();              // [rad/s] world
  std::vector<std::int32_t> nearVertex;        // per sample (nodes, then needle samples): closest surface vertex known
  std::vector<std::int32_t> otherVertex;       // the same on the other bowel, where there are two; -1 not known
  std::vector<std::int32_t> comesThrough;      // per node: 1 while it comes back through a wall (sim/suture/pierced_wall.h); empty where thread can be knotted
  std::array<Hole, kMaxHoles> holes{};
  std::int32_t holeCount = 0;
  std::array<StrandContact, kMaxContacts> contacts{};
  std::int32_t contactCount = 0;
  std::int32_t bitesBegun = 0;
};

}  // namespace halsted
