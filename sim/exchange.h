#pragma once
/// The plain structs that cross threads (DESIGN 2). Each is written by one thread and read by one other through a carrier of
/// `app/`; nothing here owns a lock, a clock or a file. Vectors are sized once at start and never resized on a running thread.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/types.h"

namespace halsted {

/// What a hand does, mapped from the device to the world. Haptic thread -> physics thread, one per hand.
/// The tool frame has its origin between the jaw tips; +z runs up the shaft toward the hand, the jaws open along +-x.
struct ToolSample {
  std::uint64_t tick = 0;                    // haptic tick that produced it
  Pose pose;                                 // device pose in the world
  Vec3 velocity = Vec3::Zero();              // [m/s] filtered device velocity
  double jaw = 1.0;                          // [1] commanded opening: 0 closed, 1 open
  std::uint32_t presses = 0;                 // counts presses of the stylus button, so that a dropped sample loses no click
};

/// Where a scripted or mouse-driven hand wants to be. Physics (expert) or main thread -> haptic thread.
struct HandTarget {
  Pose pose;
  double jaw = 1.0;                          // [1]
  bool valid = false;                        // false: the hand holds still
};

/// One half-space of the local model: the tool tip feels `normal . (x - point) >= 0`.
struct ContactPlane {
  Vec3 point = Vec3::Zero();                 // [m]
  Vec3 normal = Vec3::UnitZ();               // [1] away from the obstacle
};

/// First-order model of what one tool feels. Physics thread -> haptic thread.
///   F(x, v) = force + stiffness (position - x) ... written about the device position x0 = `position`:
///   F = force - stiffness (x - x0) - damping v
/// with `stiffness` symmetric positive semi-definite. physics.md B7.
struct LocalContact {
  static constexpr int kMaxPlanes = 4;
  std::uint64_t step = 0;                    // physics step that produced it
  Vec3 position = Vec3::Zero();              // [m] x0: device position it was computed at
  Vec3 force = Vec3::Zero();                 // [N] on the hand, at x0
  Mat3 stiffness = Mat3::Zero();             // [N/m]
  Mat3 damping = Mat3::Zero();               // [N s/m]
  std::array<ContactPlane, kMaxPlanes> planes{};
  int planeCount = 0;
  bool touching = false;                     // any contact, grasp, needle or thread load
  bool ahead = false;                        // not touching yet, but the planes are where touching would begin: render beyond them
  bool puncture = false;                     // a puncture or release happened in this step: force may jump
};

/// What happened in a step; recorded, shown and spoken, never used to steer physics.
enum class EventKind : std::uint8_t {
  kNeedleEntered, kNeedleExited, kBiteCompleted, kNeedleGrasped, kNeedleReleased, kThreadGrasped, kThreadReleased,
  kTissueGrasped, kTissueReleased, kChannelTorn, kChannelEmptied, kStepDone, kFault, kProcedureCompleted,
  kThreadBroken, kThrowTied, kThrowLost,
  kLayerPunctured,                           // index: layer from the skin; value: the surface term that fell away [N]
  kThreadCut,
  kStitchFinished,                           // index: of `State::stitches`; value: its loop [m]
  kThreadHanded,                             // index: how many are left
  kThreadRefused,                            // index: ThreadRefusal, why the assistant hands none
  kInstrumentChanged,                        // index: 0 the hand's first instrument, 1 its second
  kInstrumentRefused,                        // index: InstrumentRefusal, why it is not changed
  kTissueCut,                                // index: tet that heat has taken away; value: its heat [J]
  kPieceFree,                                // index: how many pieces hang on nothing now; value: their volume [m^3]
  kPieceTaken,                               // index: how many have been carried away; value: its volume [m^3]
  kBegunAnew,                                // index: procedure step that was under way; back to an earlier one
  kStepLate,                                 // index: procedure step that takes longer than its limit: a fault, too
  kClampHandedOver,                          // index: how many are left
  kClampRefused,                             // index: ClampRefusal, why the assistant does not take it
  kClampReleased,                            // index: which of those that stand; value: what it held [N]
  kWallPerforated                            // index: how many times now; value: what it pushed with [N]
};
const char* name(EventKind);

struct Event {
  std::uint64_t step = 0;
  EventKind kind = EventKind::kFault;
  std::int32_t hand = -1;                    // -1: no hand
  std::int32_t index = -1;                   // channel, procedure step or fault index, by kind
  double value = 0.0;                        // force [N], distance [m] or angle [rad], by kind
};

/// Everything that a picture needs of one step. Physics thread -> render thread.
struct ToolView {
  Pose pose;                                 // the proxy that touches the tissue, not the device
  double jaw = 1.0;                          // [1]
  Vec3 force = Vec3::Zero();                 // [N] on the hand
  bool second = false;                       // it holds its second instrument
  bool smokes = false;                       // a pen that is switched on where tissue is charred
};

inline constexpr int kMostClamps = 4;        // in the assistant's hands at once

/// A clamp that the assistant holds; it came out of `hand`.
struct ClampView { int hand = 0; ToolView tool; };

/// A needle in layered tissue. Inside, the needle's tool pose is that of the hand; the needle itself lies on the line of `tools[].pose`.
struct NeedlingView {
  int punctured = 0;                         // layers gone through, from the skin
  double depth = 0.0;                        // [m] of the tip below the skin at rest, along the needle; negative: above it
  std::array<double, 3> inside{};            // [m] shaft in skin, fat, muscle
  std::array<double, 3> dimple{};            // [m] how far each surface stands from its rest at the needle, inward positive
  Vec3 contact = Vec3::Zero();               // [m] where the needle touches or crosses the skin
  double angle = 0.0;                        // [rad] between needle and skin: pi / 2 is perpendicular
  double turned = 0.0;                       // [rad] net rotation since it went in
  double torque = 0.0;                       // [N m] on the needle about its axis
  double grasp = 1.0;                        // [1] factor of friction that winding has built up
  double pressed = 0.0;                      // [m] skin under the pressing finger
};

inline constexpr int kStitchPoints = 18;     // tail, knot, holes, knot, tail; sim/suture/stitch_course.h
inline constexpr int kStitchKnots[2] = {2, kStitchPoints - 3};   // of these: where the two strands meet in the knot

inline constexpr int kMostPunctures = 128;   // drawn: all that a thread can have, then those of tied stitches as far as there is room

struct RenderSnapshot {
  std::uint64_t step = 0;
  double time = 0.0;                         // [s]
  std::vector<Vec3> tissue;                  // [m] one per tissue particle
  std::vector<Vec3> thread;                  // [m] one per thread node, tail first, swage last
  std::vector<double> twist;                 // [rad] material-frame angle per thread node; no physics turns it: zero but in tests of the picture
  Pose needle;                               // needle frame, see NeedleShape
  bool threadOnTable = false;                // neither thread nor needle has been handed yet
  std::array<ToolView, kHands> tools;
  std::array<ClampView, kMostClamps> clamps;
  int clampCount = 0;
  std::vector<Vec3> punctures;               // [m] kMostPunctures long; the first punctureCount are open puncture holes
  int punctureCount = 0;
  int procedureStep = 0;                     // index of the current step; == size when completed
  std::vector<Vec3> stitches;                // [m] the thread of each tied stitch, kStitchPoints a stitch, ends included
  int stitchCount = 0;                       // drawn from `stitches`
  int stitchesDone = 0;                      // these, and one that is tied and cut off and still has its own thread
  std::uint32_t bites = 0;
  std::uint32_t faults = 0;
  double openingArea = 0.0;                  // [m^2]
  double threadTension = 0.0;                // [N] largest along the thread
  NeedlingView needling;                     // of a layered body
  std::vector<double> bruised;               // [1] one per tissue particle: for how long an instrument has pressed too hard there, over what injures (sim/damage.h)
  // Where tissue can be cut, else empty. Per triangle of RenderScene::surface:
  std::vector<std::uint8_t> exposed;         // 1 = bare; 0 = inside the tissue, or gone
  std::vector<double> charred;               // [1] heat of the tet it belongs to, over what takes that away
};

/// What never changes while a scene runs; handed to the renderer once.
enum class ToolKind : std::uint8_t { kNeedleDriver, kForceps, kAcupunctureNeedle, kFinger,
                                     kElectrocautery,   // a pen with a blade; closing the hand switches the current on
                                     kAllis,            // a clamp that grasps as forceps do
                                     kNone };           // of a second instrument: none is laid out
const char* name(ToolKind);                  // as in scene.toml

struct JawShape {                            // of one tool, as it is simulated
  double length = 12e-3, radius = 1.2e-3;    // [m] from hinge to tip; of each jaw
  double openAngle = 0.4363323129985824;     // [rad] between the jaws, fully open: 25 degrees
};

struct NeedleShape {                         // arc in the needle frame's x-y plane, centre at the origin: r (cos t, sin t, 0)
  double radius = 0.0;                       // [m] of the arc
  double angle = 0.0;                        // [rad] swept; t = 0 is the swage, t = angle the tip
  double wireRadius = 0.0;                   // [m]
};

struct CapsuleShape { Vec3 a = Vec3::Zero(), b = Vec3::Zero(); double radius = 0.0; };   // [m] all

/// A straight needle along +z of its tool frame: the tip at the origin, then shaft, then handle. Bodies of revolution.
struct StraightNeedle {
  double length = 0.0, radius = 0.0;         // [m] of the shaft; length 0: there is none
  double handleLength = 0.0, handleRadius = 0.0;   // [m]
};

/// A point of the body that can be needled, with its textbook depth and angle.
struct AcupointMark {
  std::string id, name;
  Vec3 place = Vec3::Zero();                 // [m] on the skin at rest
  Vec3 normal = Vec3::UnitY();               // [1] outward
  double depth = 0.0;                        // [m] along the needle
  double angle = 0.0;                        // [rad] between needle and skin
};

/// Nested closed surfaces instead of a wall. Vertices of all of them lie in RenderScene::tissueRest and RenderSnapshot::tissue, in
/// polar rings round the target point that are finest there. Triangles carry TissueLook in RenderScene::triangleLayer.
struct LayeredBody {
  int layers = 0;                            // 0: the tissue is a wall
  std::vector<AcupointMark> points;
  int target = -1;                           // of `points`
  std::vector<std::uint8_t> shown;           // per triangle of RenderScene::surface: Shown
  Vec3 cutNormal = Vec3::UnitZ();            // [1] of the cutaway's plane through the target, toward the half that is taken away
};
enum class TissueLook : int { kSerosa, kMucosa, kCutRim, kSkin, kFat, kMuscle, kSkinSection, kFatSection, kMuscleSection };
inline constexpr int kTissueLooks = 9;
enum class Shown : std::uint8_t { kAlways, kWhole, kCutaway };   // kWhole: taken away by the cutaway; kCutaway: seen in it only

struct CameraView { Vec3 eye = Vec3(0, 0.05, 0.12), target = Vec3::Zero(), up = Vec3::UnitY(); double fovDegrees = 40.0; };

struct RenderScene {
  std::string name, title;
  std::vector<Vec3> tissueRest;              // [m]
  std::vector<std::array<int, 3>> surface;   // triangles, counter-clockwise seen from outside the wall
  std::vector<int> triangleLayer;            // per triangle, a TissueLook: 0 serosa (outside), 1 mucosa (lumen), 2 cut rim and ends
  std::vector<Eigen::Vector2d> surfaceUv;    // per particle: (angle/2pi, length along the tube [m])
  int threadNodes = 0;
  double threadRadius = 0.0;                 // [m]
  NeedleShape needle;
  bool perineum = false;                     // skin round a prolapse instead of an open wound; bowel 0 is then inside out
  LayeredBody body;                          // of a scene that needles a body; triangles of hidden layers are in `surface` too
  StraightNeedle straightNeedle;
  double fingerRadius = 0.0;                 // [m] 0: no pressing finger
  bool cutaway = false;                      // as the scene opens; the viewer may change it
  std::vector<CapsuleShape> rods;            // fixed rods (the anvil)
  std::array<ToolKind, kHands> tools{ToolKind::kForceps, ToolKind::kNeedleDriver};
  std::array<JawShape, kHands> jaws;
  std::array<ToolKind, kHands> secondTools{ToolKind::kNone, ToolKind::kNone};
  std::array<JawShape, kHands> secondJaws;
  CameraView camera;
  Vec3 up = Vec3::UnitY();                   // [1] against gravity
  std::vector<std::string> instructions;     // one per procedure step
  std::vector<std::string> stepIds;
  int stitchesWanted = 0;                    // of the whole procedure; 0: it does not repeat
  int maxStitches = 0;
};

/// Levels for the panels and the HUD.
struct HapticStatus {
  std::uint64_t tick = 0, skippedPeriods = 0, staleTicks = 0;
  std::array<Vec3, kHands> force{Vec3::Zero(), Vec3::Zero()};   // [N] sent to the device
  std::array<std::uint32_t, kHands> faultCode{};                // haptics/limits.h
};
struct PhysicsStatus {
  std::uint64_t step = 0, lateSteps = 0;
  double stepMilliseconds = 0.0;             // [ms] cost of the last step
};

/// What is asked of the assistant while running; main thread -> physics thread, between two steps, recorded.
struct Command {
  enum class Kind : std::uint8_t { kNone, kSetGravity, kReset,   // these two nobody asks for and no step answers: sessions store the numbers of those that follow
                                   kFreshThread,  // the assistant hands a needled thread; sim/suture/fresh_thread.h
                                   kChangeInstrument,  // of hand `value`; sim/tools/instrument.h
                                   kHandOver           // the clamp in hand `value` to the assistant; sim/tools/standing_clamps.h
  } kind = Kind::kNone;
  double value = 0.0;                        // [1] or the unit of the kind
};

}  // namespace halsted
