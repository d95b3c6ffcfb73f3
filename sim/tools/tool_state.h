#pragma once
#include <array>
#include <cstdint>

#include "sim/types.h"

namespace halsted {

/// Tissue between a pair of jaws: points of surface triangles.
struct TissueGrasp {
  static constexpr int kMost = 6;
  std::int32_t count = 0;
  std::array<std::int32_t, kMost> triangle{};
  std::array<std::array<double, 3>, kMost> weight{};   // [1]
  std::array<Vec3, kMost> local = zeroVectors<kMost>();   // [m] held point in the tool frame
  std::array<Vec3, kMost> force = zeroVectors<kMost>();   // [N] on the tissue
};

/// What one hand's jaws hold and feel. Written by sim/tools.
struct ToolState {
  static constexpr int kMaxContacts = 24, kMaxNear = 512;
  Pose device;                                 // last sample consumed; nearer to the tool where the hand has given way (ToolParams::handForce)
  Pose proxy;                                  // where the simulated tool is
  Vec3 lag = Vec3::Zero();                     // [m] of the tool behind where its coupling would have it, since what it pulled at has come free
  double jaw = 1.0;                            // [1]
  bool closed = false;                         // jaws shut enough to hold
  bool ratchet = false;                        // locked shut, as a loaded needle driver is handed over; the first squeeze unlocks it
  Vec3 force = Vec3::Zero();                   // [N] total on the hand
  // Needle and thread in the jaws.
  bool holdsNeedle = false;
  double needleCoordinate = 0.0;               // [m] strand coordinate where the jaws hold the needle
  Pose needleInTool;                           // needle frame in the tool frame at the grasp
  Vec3 needleForce = Vec3::Zero();             // [N] on the tool
  double threadCoordinate = -1.0;              // [m] strand coordinate held, < 0 none
  Vec3 threadInTool = Vec3::Zero();            // [m] of that in the tool frame
  Vec3 threadForce = Vec3::Zero();             // [N] on the tool
  Vec3 strandForce = Vec3::Zero();             // [N] on the tool, thread and needle lying against it
  TissueGrasp grasp;                           // tissue in the jaws
  // Tissue against the tool.
  bool through = false;                        // it has gone through the wall: sim/tools/perforation.h
  std::int32_t contactCount = 0;
  std::array<std::int32_t, kMaxContacts> contactTriangle{};
  std::array<std::array<double, 3>, kMaxContacts> contactWeight{};   // [1]
  std::array<Vec3, kMaxContacts> contactNormal = zeroVectors<kMaxContacts>();                     // [1] from the tool into the tissue
  std::array<Vec3, kMaxContacts> contactForce = zeroVectors<kMaxContacts>();   // [N] on the tissue
  std::int32_t nearCount = 0;                  // surface triangles near the tool, refreshed every few steps
  std::array<std::int32_t, kMaxNear> nearTriangle{};
};

/// Do the jaws hold nothing?
inline bool jawsEmpty(const ToolState& t) { return !t.holdsNeedle && t.threadCoordinate < 0.0 && t.grasp.count == 0; }

}  // namespace halsted
