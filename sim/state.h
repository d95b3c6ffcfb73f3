#pragma once
/// Everything a step changes. One field list (`visitFields`) serves hash, save, load and diff.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/exchange.h"
#include "sim/metrics.h"
#include "sim/procedure.h"
#include "sim/types.h"

namespace halsted {

/// Written by sim/tissue.
struct TissueState {
  std::vector<Vec3> position, velocity;        // [m], [m/s] one per particle
  std::vector<Quat> rotation;                  // per tet (projective) or cluster (shape matching): warm start of the polar factor
  std::vector<double> pressure;                // [Pa] per tet: volumetric part of the stress (projective)
};

/// A point of the tissue that a strand passes through. Sorted along the strand in StrandState::holes.
struct Hole {
  std::int32_t tet = -1;                       // -1: slot is free
  std::array<double, 4> weight{};              // [1] barycentric in the tet
  double coordinate = 0.0;                     // [m] material coordinate of the strand at the hole: 0 tail, L swage, L + arc tip
  Vec3 force = Vec3::Zero();                   // [N] on the strand
  std::int32_t bite = -1;                      // which bite it belongs to
  std::int32_t role = 0;                       // 0 entry, 1 exit, 2 inside the wall, 3 the tip while inside
};

/// A unilateral contact of a strand sample with tissue, tool or rod; kept for warm start.
struct StrandContact {
  std::int32_t sample = -1;                    // thread node, or nodes + needle sample
  std::int32_t feature = -1;                   // surface triangle, or triangles + capsule index
  Vec3 force = Vec3::Zero();                   // [N] on the strand
};

/// Thread and needle, one strand. Written by sim/strand.
struct StrandState {
  static constexpr int kMaxHoles = 64, kMaxContacts = 256;
  std::vector<Vec3> position, velocity;        // [m], [m/s] thread nodes, tail first
  std::vector<double> tension;                 // [N] per segment
  Pose needle;
  Vec3 needleVelocity = Vec3::Zero();          // [m/s]
  Vec3 needleSpin = Vec3::Zero();              // [rad/s] world
  std::array<Hole, kMaxHoles> holes{};
  std::int32_t holeCount = 0;
  std::array<StrandContact, kMaxContacts> contacts{};
  std::int32_t contactCount = 0;
  std::int32_t biteCount = 0;                  // bites begun
};

/// What one hand's jaws hold and feel. Written by sim/tools.
struct ToolState {
  static constexpr int kMaxGrasp = 6, kMaxContacts = 24;
  Pose device;                                 // last sample consumed
  Pose proxy;                                  // where the simulated tool is
  double jaw = 1.0;                            // [1]
  Vec3 force = Vec3::Zero();                   // [N] total on the hand
  bool holdsNeedle = false;
  Pose needleInTool;                           // needle frame in the tool frame at the grasp
  double threadCoordinate = -1.0;              // [m] material coordinate held, < 0 none
  Vec3 threadForce = Vec3::Zero();             // [N] on the tool
  Vec3 needleForce = Vec3::Zero();             // [N] on the tool
  std::int32_t graspCount = 0;                 // tissue points held
  std::array<std::int32_t, kMaxGrasp> graspNode{};
  std::array<Vec3, kMaxGrasp> graspLocal{};    // [m] held point in the tool frame
  std::array<Vec3, kMaxGrasp> graspForce{};    // [N] on the tissue
  std::int32_t contactCount = 0;
  std::array<std::int32_t, kMaxContacts> contactTriangle{};
  std::array<Vec3, kMaxContacts> contactForce{};   // [N] on the tissue
};

struct State {
  std::uint64_t step = 0;                      // time = step * dt
  std::uint64_t random = 1;                    // generator state (splitmix64)
  TissueState tissue;
  StrandState strand;
  std::array<ToolState, kHands> tools;
  ProcedureState procedure;
  MetricsState metrics;
};

/// FNV-1a over every field, in field-list order.
std::uint64_t hash(const State&);
std::vector<std::uint8_t> save(const State&);
/// False (and `error` says which field) when the bytes do not fit this state's sizes.
bool load(const std::vector<std::uint8_t>& bytes, State&, std::string& error);
/// Empty when equal; otherwise the first difference: field, index and both values.
std::string diff(const State& a, const State& b);

}  // namespace halsted
