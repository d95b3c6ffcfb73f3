#pragma once
/// Scratch memory of a step, sized once by `initialState`; its contents mean nothing between steps.
#include <array>
#include <vector>

#include "sim/cutting/cut_state.h"
#include "sim/line_vector.h"
#include "sim/strand/knot_diagram.h"
#include "sim/strand/strand.h"
#include "sim/strand/thread_contacts.h"
#include "sim/suture/tied_stitches.h"
#include "sim/suture/tissue_point.h"
#include "sim/tissue/tissue_state.h"
#include "sim/tools/tool_state.h"
#include "sim/types.h"

namespace halsted {

/// Used by sim/tissue.
struct TissueWork {
  std::vector<Vec3> previous;                  // [m] positions at the start of the step
  std::vector<Vec3> target;                    // per particle; by solver
  LineVector<double> rows;                     // [m] or [N] per particle: four doubles for the factored solve
  LineVector<double> scratch;                  // [1] by solver
};

/// Used by sim/suture: per hole, the tissue's own compliance there, and a bound that includes the pull of the other holes.
struct HoleWork {
  static constexpr int kNeighbours = 3;        // the holes that follow, whose push counts in a hole's bound
  std::array<double, StrandState::kMaxHoles> self{}, bound{};   // [m/N]
  int aloneCount = 0;
  std::array<std::int32_t, StrandState::kMaxHoles> alone{};     // those whose bite has no other hole
  int count = 0;
  std::array<double, StrandState::kMaxHoles> coordinate{};      // [m] of the strand, ascending: every sample asks between which it lies
  std::array<bool, StrandState::kMaxHoles> paired{};            // the next hole is of the same bite
  std::array<Vec3, StrandState::kMaxHoles> point{};             // [m] the hole in the predicted tissue
  // A hole stays where it is in the tissue: its compliances are read anew only where it has another place than `seen`.
  std::array<TissuePoint, StrandState::kMaxHoles> seen{};
  std::array<std::array<double, kNeighbours>, StrandState::kMaxHoles> shared{};   // [m/N] size, with each that follows
};

/// Used by sim/suture/exchange.h: vertices that stand for places where thread pushes on the tissue, how many of them, and sums asked for.
struct VertexCount {
  static constexpr int kMost = 256;
  int count = 0;
  std::array<std::int32_t, kMost> vertex{}, times{};
};
struct RowSums {
  int count = 0;
  std::array<std::int32_t, VertexCount::kMost> vertex{};
  std::array<double, VertexCount::kMost> sum{};   // [m/N]
};
struct ExchangeWork {
  VertexCount contacts, holes;
  RowSums byContacts, byHoles;
};

/// Used by sim/contact: all pairs of a turn's triangles that can be near while no vertex goes farther than kPairDrift from `place`.
/// The one thing here that outlives a step: it speeds a search up and never changes what the search finds (sim/contact/pair_search.h).
struct NearPairs {
  static constexpr int kMost = 4096;
  bool whole = false, used = false;            // holds all of them; has served since it was made
  int count = 0;
  std::int32_t goneTets = 0;                   // when it was made: it holds while no more are
  std::vector<std::int32_t> vertex, triangle;  // ascending triangles
  std::vector<double> far;                     // [m] from one to the other when the list was made
  std::vector<Vec3> place;                     // [m] the surface's vertices at the last search through the cells
};

/// Used by sim/contact: a surface vertex over a triangle.
struct PairGap {
  bool near = false;                           // to be watched
  double height = 0.0;                         // [m] of the vertex over the triangle's plane
  std::array<double, 3> weight{};              // [1] the triangle's point nearest to the vertex
  Vec3 normal = Vec3::UnitZ();                 // [1] outward
};

/// Used by sim/contact: the surface's vertices in a grid of cells, and the pairs of the triangles whose turn it is as the last round
/// left them.
struct SelfWork {
  static constexpr int kAxis = 16, kCells = kAxis * kAxis * kAxis;
  static constexpr int kRound = 8;             // [1] steps after which every triangle has been looked at
  std::array<NearPairs, kRound> nearby;        // per turn
  std::array<std::int32_t, kCells + 1> start{};
  std::vector<std::int32_t> cell, item;        // per surface vertex: its cell; vertices sorted by cell
  std::vector<double> place;                   // [m] x of all `item`, then y, then z; a little longer, to be read four at a time
  std::vector<std::int32_t> inside;            // of the run being looked at; as long as `item`
  std::vector<std::int32_t> ring;              // per vertex: the last triangle of which it is a neighbour, or that it stays in a pair with
  int count = 0;
  std::array<std::int32_t, TissueState::kMaxPairs> vertex{}, triangle{};
  std::array<double, TissueState::kMaxPairs> force{};   // [N]
  int touching = 0;                            // pairs that may push in this sweep: which, and how they stand
  std::array<std::int32_t, TissueState::kMaxPairs> pair{};
  std::array<PairGap, TissueState::kMaxPairs> gap;
  std::vector<double> nearest;                 // [m] per particle: how far behind the nearest face, of those in `pair`
  std::vector<double> give;                    // [1] contacts that push each particle, then [m/N] how far it goes when all do
};

/// Used by sim/contact: boxes about the surface's vertices, kVertices of them at a time, where they are in this step.
struct VertexBoxes {
  static constexpr int kVertices = 16;
  bool filled = false;
  std::vector<Vec3> low, high;                 // [m]
};

/// Used by sim/tools: the contacts and grasps of both tools as one small problem on the tissue's compliance.
struct TouchPoint {
  int hand = 0, triangle = -1;                 // kHands + k: the k-th standing clamp
  bool grasp = false;                          // bilateral: held between the jaws
  bool sunk = false;                           // the tool's axis lies below the surface
  bool gone = false;                           // no contact any more: stays in the problem because its old force is taken back
  std::array<double, 3> weight{};              // [1]
  Vec3 normal = Vec3::UnitZ();                 // [1] from the tool into the tissue
  Vec3 toolPoint = Vec3::Zero();               // [m] world point of the tool's surface
  double gap = 0.0;                            // [m] along the normal, before the forces of this step change
  Vec3 slide = Vec3::Zero();                   // [m] of tissue past tool in this step, or the whole error of a grasp
  Vec3 old = Vec3::Zero(), force = Vec3::Zero();   // [N] on the tissue: carried into the step, and now
  double slipLimit = 0.0;                      // [N] of a grasp
};

struct TouchWork {
  static constexpr int kMax = kHands * (2 * ToolState::kMaxContacts + TissueGrasp::kMost) + kMostClamps * TissueGrasp::kMost;
  std::array<TouchPoint, kMax> point;
  int count = 0;
  std::array<double, kMax * kMax> compliance{};    // [m/N] tissue between points, plus the coupling of their common tool
};

/// Used by sim/suture/tied_stitches.h: how far each hole of a loop goes when the holes of all other loops are pulled as hard as it. Holes stay where they are
/// in the tissue: made anew only where there are others than `hole`.
struct StitchWork {
  int count = 0;                               // loops it holds for
  std::array<std::array<TissuePoint, TiedStitch::kMostHoles>, TiedStitches::kMost> hole{};
  std::array<std::array<double, TiedStitch::kMostHoles>, TiedStitches::kMost> others{};   // [m/N]
};

/// Used by sim/damage.h.
struct DamageWork {
  std::vector<std::array<double, 2>> pressure; // [Pa] per particle, of an instrument and of the strand; zero between steps
  std::vector<std::int32_t> pressed;           // particles whose pressure is not zero
};

struct StepWork {
  TouchWork touch;
  TissueWork tissue;
  StrandWork strand;
  ThreadContactWork threadContacts;            // empty unless `thread.knots`
  std::array<ThreadSolid, kHands * 3 + 1> threadSolids;   // what the thread may lie against, in a substep
  KnotReader knotReader;
  HoleWork holes;
  StitchWork stitches;
  ExchangeWork exchange;
  std::array<StrandContact, StrandState::kMaxContacts> freshContacts;   // found in this step
  std::array<int, StrandState::kMaxContacts> freshLink{};   // of each, in `strand`
  int freshCount = 0;
  StrandState strandBefore;                    // as the step's solve began: it may have to be done again
  ThreadContactState threadBefore;
  std::vector<Vec3> force;                     // [N] per particle: what the tissue carried from the last step
  std::vector<Vec3> change;                    // [N] per particle: what contacts changed in this one
  SelfWork self;
  VertexBoxes boxes;
  CutWork cut;
  DamageWork damage;
};

}  // namespace halsted
