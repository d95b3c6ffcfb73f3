#pragma once
/// A needle and a pressing finger on layered tissue whose surfaces are sums of harmonics (acupuncture-force-net 2021). The step is a
/// function of its arguments: + - * / sqrt only, no heap, the same bits everywhere. Physics or haptic thread.
#include <vector>

#include "sim/exchange.h"
#include "sim/harmonics/surface.h"
#include "sim/needling/force_net.h"
#include "sim/needling/shaft.h"

namespace halsted {

struct NeedlingModel {                         // constant in a step
  NeedlingParams params;
  std::array<HarmonicSurface, kLayers> surface;   // tops of skin, fat, muscle
  std::array<ForceNet, kLayers> net;
};

/// Throws std::invalid_argument naming the parameter that makes no sense.
NeedlingModel needlingModel(const NeedlingParams&, const std::array<HarmonicSurface, kLayers>&);

/// Kept as a number in the state, which holds nothing but numbers (sim/fields.h).
struct LayerPhase { enum : std::int32_t { kFree, kDimpled, kPunctured }; };

struct LayerState {
  std::int32_t phase = LayerPhase::kFree;      // LayerPhase
  double crossing = 0.0;                       // [m] along the needle's line, where this layer's surface was at rest
  double since = 0.0;                          // [s] since the puncture
  Vec3 normal = Vec3::UnitZ();                 // [1] outward, at the net's middle
  std::vector<Vec3> rest, now;                 // [m] points of the net and of the ring that supports it
};

struct NeedlingState {
  std::uint64_t step = 0;
  Vec3 skinUnit = Vec3::UnitZ(), fingerUnit = Vec3::UnitZ();   // where on the sphere the needle's and the finger's nearest points are
  Vec3 contact = Vec3::Zero(), outward = Vec3::UnitZ();        // [m], [1] the touched point of the skin at rest, and its normal there
  Vec3 entry = Vec3::Zero(), axis = Vec3::UnitZ();             // [m], [1] line of the needle inside; the axis points inward
  std::array<LayerState, kLayers> layers;
  double depth = 0.0;                          // [m] of the tip along the axis below the skin at rest; before puncture, along the normal
  double pressed = 0.0;                        // [m] along the axis, by which the finger has moved the tissue at the needle
  double fingerDepth = 0.0;                    // [m] the skin is pressed in
  Vec3 fingerPlace = Vec3::Zero(), fingerNormal = Vec3::UnitZ();   // [m], [1]
  Quat needleTurn = Quat::Identity();          // orientation at the last step
  ShaftFriction friction;
  TipCut cut;
  Winding winding;
  std::array<double, kLayers> inside{};        // [m] shaft in each layer
};

struct NeedlingInput { ToolSample needle, finger; };   // the needle's tool frame has its origin at the tip, +z toward the hand

struct NeedlingOutput {
  LocalContact needle, finger;
  double torque = 0.0;                         // [N m] on the needle about its axis
  double surfaceForce = 0.0;                   // [N] of the force nets, outward along the needle
  double frictionForce = 0.0, cutForce = 0.0, dampingForce = 0.0;   // [N] outward along the needle
  std::array<double, kLayers> inside{};        // [m] shaft in each layer
  int punctured = -1;                          // layer that gave way in this step
  double lostSurfaceForce = 0.0;               // [N] of its force net, which fell away
  bool leftSkin = false;
};

NeedlingState needlingState(const NeedlingModel&);

void stepNeedling(const NeedlingModel&, const NeedlingInput&, NeedlingState&, NeedlingOutput&);

/// How far the skin is pressed in at a place by the finger: all of it under the finger, a / r beyond.  [m]
double pressedDepth(const NeedlingModel&, const NeedlingState&, const Vec3& place);   // place [m]

/// How far a layer's surface stands beyond its place at rest where the needle's line crosses it, along that line.  [m]
double dimple(const NeedlingState&, int layer);

}  // namespace halsted
