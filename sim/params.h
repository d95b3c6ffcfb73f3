#pragma once
/// Every number a scene file may set. Defaults are the purse-string scene; `scenes/` reads them from TOML by the key beside each.
/// Presets with sources stand in `scenes/materials.toml`; physics.md section D.
#include <string>

#include "sim/exchange.h"
#include "sim/needling/needling_params.h"
#include "sim/types.h"

namespace halsted {

enum class ModelKind : std::uint8_t { kSuture, kNeedling };   // sim.model = "suture" | "needling"

enum class ThreadAssist : std::uint8_t { kNone, kKnot };   // thread.assist = "none" | "knot"

enum class TissueSolver : std::uint8_t { kProjective, kXpbd, kShapeMatching };   // tissue.solver

struct TissueParams {                          // [tissue]
  TissueSolver solver = TissueSolver::kProjective;
  double youngsModulus = 120e3;                // youngs_modulus [Pa] handling range: a tenth of the large-strain 0.63 to 1.76 MPa
  double poissonRatio = 0.45;                  // poisson_ratio [1]
  double stiffening = 5.25;                    // stiffening [1] slope of stress over strain past the toe, over that within; projective only
  double toeStrain = 0.2;                      // toe_strain [1] |F - R| where the collagen is stretched out (Massalou 2019: 0 to 20 %)
  double density = 1060.0;                     // density [kg/m^3]
  double massDamping = 5.0;                    // mass_damping [1/s] mesentery and fluid; tuned: rim swing dies in half a second
  int substeps = 0;                            // substeps [1] xpbd, shape_matching; 0 = chosen so that the stiffness is true
  double resistance = 0.65;                    // resistance [1] shape_matching only (paper 003)
  int shapeIterations = 2;                     // shape_iterations [1] shape_matching only
  double perforationForce = 13.5;              // perforation_force [N] a blunt instrument that pushes harder goes through (a pig's colon; Heijnsdijk 2003)
  bool bedded = false;                         // bedded: what it lies on carries its weight; false: it hangs from what is held in place
};

struct ContactParams {                         // [contact]
  double toolTissueFriction = 0.2;             // tool_tissue_friction [1] wet steel on serosa (design)
  double threadTissueFriction = 0.15;          // thread_tissue_friction [1] coated thread, physics.md D (design)
  double threadToolFriction = 0.2;             // thread_tool_friction [1] (design)
};

struct ThreadParams {                          // [thread]
  int nodes = 175;                             // nodes [1] paper 003
  double segmentLength = 2e-3;                 // segment_length [m] physics.md 0.1
  double radius = 0.16e-3;                     // radius [m] USP 2-0: 0.300 to 0.339 mm diameter
  double linearDensity = 5e-5;                 // linear_density [kg/m] 0.1 mg per 2 mm
  double axialStiffness = 1500.0;              // axial_stiffness [N] EA; 1 N stretches 0.07 %; braided silk itself is 785 N
  double bendingStiffness = 5e-8;              // bending_stiffness [N m^2] braided, physics.md D
  double yieldMoment = 2e-5;                   // yield_moment [N m] with `knots`: bent tighter than 2.5 mm a braid takes a set (design); 0: elastic
  double damping = 20.0;                       // damping [1/s] air and internal; tuned: a dropped thread settles in 0.2 s
  double channelDrag = 8.0;                    // channel_drag [N/m] drag per length of channel (design)
  // Where knots are tied the thread has finer nodes; the ends fall on nodes of the rest. fine_segment 0: nowhere.
  double fineFrom = 0.0, fineTo = 0.0;         // fine_from, fine_to [m] coordinates, 0 = free tail
  double fineSegment = 0.0;                    // fine_segment [m] 0.2 to 0.4 mm make a knot of its own size
  bool knots = false;                          // knots: thread meets itself, and tools within its own solve
  int substeps = 4;                            // substeps [1] of the strand in a step, with knots
  double friction = 0.30;                      // friction [1] thread on thread; see ThreadContactParams
  double lateralModulus = 5e8;                 // lateral_modulus [Pa] of a squeezed braid (design)
  // For beginners: crossing the tails and drawing them places a knot that holds. Not physics; only with `knots`. sim/suture/assist_knot.h
  ThreadAssist assist = ThreadAssist::kNone;   // assist
  double assistTension = 0.5;                  // assist_tension [N] in both tails
  double assistHolding = 10.0;                 // assist_holding [N] a loop of several throws bears 15 N and more (physics.md B5)
  int spare = 0;                               // spare [1] needled threads that the assistant can hand after the first; sim/suture/fresh_thread.h
  double breakingTension = 26.3;               // breaking_tension [N] USP knot-pull minimum, 2-0 synthetic absorbable (physics.md D)
};

struct NeedleParams {                          // [needle]
  double arcLength = 26e-3;                    // arc_length [m] SH
  double arcAngle = 3.14159265358979312;       // arc_angle [rad] half circle
  double wireRadius = 0.33e-3;                 // wire_radius [m]
  double density = 7900.0;                     // density [kg/m^3] steel
  double punctureForce = 0.8;                  // puncture_force [N] bowel 0.5 to 2 N, physics.md D
  double exitForce = 0.25;                     // exit_force [N] tip leaving through the surface (design)
  double cutForce = 0.15;                      // cut_force [N] tip advancing inside the wall (design)
  double tearForce = 6.0;                      // tear_force [N] lateral load at which a hole tears (design)
  double shaftFriction = 20.0;                 // shaft_friction [N/m] Coulomb friction per inserted length (design)
};

struct ToolParams {                            // [tool.left], [tool.right]; [tool.left.second], [tool.right.second]
  ToolKind kind = ToolKind::kNeedleDriver;     // kind = "needle_driver" | "forceps" | "acupuncture_needle" | "finger" | "electrocautery" | "allis"; "none" of a second
  double jawLength = 12e-3;                    // jaw_length [m]
  double jawRadius = 1.2e-3;                   // jaw_radius [m]
  double shaftRadius = 2.2e-3;                 // shaft_radius [m]
  double shaftLength = 90e-3;                  // shaft_length [m]
  double jawAngleDegrees = 25.0;               // jaw_angle_degrees [deg] fully open, between the jaws
  double captureRadius = 2.5e-3;               // capture_radius [m] what lies this near the jaws' centre line is grasped
  double gripForce = 4.0;                      // grip_force [N] above it the grasped tissue slips out
  bool cutter = false;                         // cutter: blades behind the jaws cut thread (Olsen-Hegar); only with thread.knots
  double couplingStiffness = 1000.0;           // coupling_stiffness [N/m] of the hand, whatever it holds; from the device's nominal 1.02 N/mm (devices.md)
  double handForce = 20.0;                     // hand_force [N] a hand that is held back gives way: it pushes and pulls no harder (design; scripts need up to 15)
};

inline ToolParams withoutTool() {
  ToolParams none;
  none.kind = ToolKind::kNone;
  return none;
}

/// An electrocautery pen (kind = "electrocautery"); sim/cutting/burn.h.
struct CauteryParams {                         // [cautery]
  double power = 30.0;                         // power [W] of pure cut; 20 to 60 W are usual (design)
  // cutting_energy [J/m^3] to take tissue away as steam, the tissue counted as water: 1000 kg/m^3 (4.18 kJ/(kg K) 63 K + 2257 kJ/kg)
  double cuttingEnergy = 2.52e9;
  double tipRadius = 0.6e-3;                   // tip_radius [m] of the electrode, and of the pen's blade
  double reach = 0.4e-3;                       // reach [m] from the electrode's surface: how deep its heat goes at once (design)
  double takeAway = 30e-3;                     // take_away [m] a free piece that has been carried this far is taken out of the scene
  double crumb = 8e-9;                         // crumb [m^3] a free piece no larger is sucked away with the smoke (design)
};

/// Who stands beside; sim/tools/standing_clamps.h.
struct AssistantParams {                       // [assistant]
  int clamps = 0;                              // clamps [1] that lie ready for a hand that has given its own over
};

struct AnatomyParams {                         // [anatomy]
  std::string mesh;                            // mesh: a surface file; empty = the procedural colon
  double scale = 1.0;                          // scale [m per mesh unit]
  std::string segment;                         // segment: which stretch of the tube; empty = the straightest with the roundest rim
  double radius = 18e-3;                       // radius [m] of the procedural tube's outer wall
  double length = 60e-3;                       // length [m]
  double wall = 2e-3;                          // wall [m]
  double haustraDepth = 2.0e-3;                // haustra_depth [m]
  int around = 34, along = 18;                 // around, along [1] grid of one layer; two layers
  std::string layout = "one_end";              // layout = "one_end" | "two_ends" | "end_to_end" | "prolapse"
  double gap = 8e-3;                           // gap [m] between the walls of two ends, or of a prolapse
  // Of a prolapse; `length` is how far it stands out:
  double cutHeight = 12e-3;                    // cut_height [m] of the planned line over the base, 10 to 15 mm over the dentate line
  double cutBand = 3e-3;                       // cut_band [m] to either side of it the wall may be cut; farther away heat chars, counts as overshoot and takes nothing away
  // A body that is needled:
  std::string body;                            // body: table of its acupoints, scenes/NAME/bodies/BODY.toml; empty = the mesh's own, or the slab
  std::string point;                           // point: the acupoint to be needled; empty = the table's first
  std::string layersFrom;                      // layers_from: a CT's mask of subcutaneous fat, its muscle beside it: they give the thicknesses
  double layersAngle = 0.0;                    // layers_angle_degrees [deg] where on the CT's outline: 0 the front, 90 the patient's left
  int order = 15;                              // order [1] of the harmonics
};

struct RodParams {                             // [anvil]
  Vec3 from = Vec3(0, 0, -30e-3);              // from [m]
  Vec3 to = Vec3(0, 0, 12e-3);                 // to [m]
  double radius = 3.0e-3;                      // radius [m] shaft of a stapler anvil
};

struct SimParams {
  ModelKind model = ModelKind::kSuture;        // sim.model
  double dt = 1e-3;                            // sim.dt [s]
  Vec3 gravity = Vec3(0, -9.81, 0);            // sim.gravity [m/s^2]
  std::uint64_t seed = 1;                      // sim.seed
  TissueParams tissue;
  ContactParams contact;
  ThreadParams thread;
  NeedleParams needle;
  ToolParams tools[kHands];
  ToolParams second[kHands] = {withoutTool(), withoutTool()};   // what a hand may change its instrument for: sim/tools/instrument.h
  CauteryParams cautery;
  AssistantParams assistant;
  AnatomyParams anatomy;
  RodParams anvil;
  NeedlingParams needling;                     // [needling]; its keys stand in scenes/scene_fields_needling.cpp
};

}  // namespace halsted
