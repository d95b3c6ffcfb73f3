#pragma once
/// Outcome and motion metrics, accumulated step by step (physics.md C1). `MetricsState` is part of `State`.
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/join.h"
#include "sim/mesh.h"
#include "sim/needling/strokes.h"
#include "sim/types.h"

namespace halsted {

struct HandMetrics {
  double pathLength = 0.0;                     // [m] sum |dx| of the tool tip
  double peakForce = 0.0;                      // [N]
  double forceSum = 0.0;                       // [N] over steps with force > 0.02 N
  double forceSteps = 0.0;                     // [1] count of those steps
  Vec3 lastPosition = Vec3::Zero();            // [m]
  bool started = false;
};

struct BiteMetrics {
  double depth = 0.0;                          // [m] entry to the rim
  double spacing = 0.0;                        // [m] from the previous exit
  double entryAngle = 0.0;                     // [1] cosine of the angle between needle tangent and inward normal at entry
  double width = 0.0;                          // [m] entry to exit
};

/// Acupuncture (physics.md C3). Of the needle's first stay in the skin, until it has left.
struct NeedlingMetrics {
  bool entered = false, left = false;
  double entryOffset = 0.0;                    // [m] from the acupoint to where the skin was pierced
  double angle = 0.0;                          // [rad] between needle and skin as it went in
  double deepest = 0.0;                        // [m] of the tip along the needle
  double depthError = 0.0;                     // [m] deepest beyond the textbook depth; negative: short of it
  double enteredAt = 0.0, reachedAt = 0.0, leftAt = 0.0;   // [s] skin pierced; depth first within 1 mm; out again
  double peakForce = 0.0;                      // [N] while going in
  double peakPull = 0.0;                       // [N] with which the tissue held the needle back on its way out
  double peakGrasp = 1.0;                      // [1]
  double peakTorque = 0.0;                     // [N m]
  double peakWithdrawal = 0.0;                 // [m/s] fastest way out
  Strokes lifts, twirls;                       // [m], [rad]
  double turned = 0.0, lastTurned = 0.0;       // [rad] all rotation, both ways; net rotation at the last step
};

/// Of tissue that is cut; `TetMesh::cutLine` says where it should be.
struct CutMetrics {
  std::array<double, kCutWalls> share{};       // [1] outer and inner wall: of the circumference that is cut through
  double errorMean = 0.0, errorWorst = 0.0;    // [m] of burnt tets from the line, by volume
  double energy = 0.0;                         // [J] that the pen has given to tissue
  double overshoot = 0.0;                      // [J] of it where it should not be: off the line's walls, or in the inner one before the outer one is through
  double time = 0.0;                           // [s] with current through tissue
  double freeVolume = 0.0;                     // [m^3] of the free pieces
  std::int32_t burnt = 0;                      // tets
  std::int32_t freePieces = 0, taken = 0, crumbs = 0;   // hang on nothing now; have been carried away; have been sucked away
  bool current = false;                        // flowed in this step
};

/// What the wall has borne; sim/damage.h. By instruments, and by thread and needle that lie on it.
enum class Presser : std::uint8_t { kInstrument, kStrand, kCount };
inline constexpr int kPressers = static_cast<int>(Presser::kCount);
struct DamageMetrics {
  std::array<double, kHands> forceTime{};      // [N s] force of each hand's instrument on the wall, over time
  std::array<double, kPressers> peakPressure{};   // [Pa] of a cell
  std::array<double, kPressers> dose{};        // [N s] pressure beyond kTraumaPressure, over area and time
  std::array<double, kPressers> injured{};     // [m^2] that has borne more than that for kTraumaTime in all
};

inline constexpr int kMaxBites = 24;

/// Of two ends that are being joined.
struct SeamMetrics {
  JoinMetrics join;                            // as last looked at
  std::array<double, kMaxBites> wallShare{};   // [1] per bite: deepest point of the needle's way, 0 serosa, 1 mucosa
  std::int32_t fullThickness = 0;              // bites that went through the mucosa
  double deepestTip = 0.0;                     // [1] share of the wall that the needle's tip has reached since the last bite
  std::int32_t lastBowel = 0;                  // of the last bite
};

struct MetricsState {
  std::array<HandMetrics, kHands> hands;
  std::array<BiteMetrics, kMaxBites> bites{};
  std::int32_t biteCount = 0;                  // completed bites
  Vec3 lastExit = Vec3::Zero();                // [m] rest position of the last bite's exit
  std::int32_t acrossOpening = 0;              // bites not adjacent to the last
  std::int32_t tears = 0;
  std::int32_t perforations = 0;               // of the wall, by instruments
  DamageMetrics damage;
  double peakStretch = 1.0;                    // [1] largest edge length / rest length on the surface
  double peakTension = 0.0;                    // [N]
  double openingArea = 0.0;                    // [m^2] now
  double restOpeningArea = 0.0;                // [m^2] at the first step
  std::optional<SeamMetrics> seam;             // of two ends that are being joined
  std::optional<std::int32_t> assistedKnots;   // locked, with `thread.assist`
  std::optional<CutMetrics> cut;               // where tissue can be cut
  std::optional<NeedlingMetrics> needling;     // of a body that is needled; then nothing but the hands counts above
};

/// Name (with its unit as a suffix) and value, for `replay --json` and reports; read on any thread that owns a copy.  time [s]
std::vector<std::pair<std::string, double>> summarise(const MetricsState&, double time);

}  // namespace halsted
