#pragma once
/// Thread against thread, and against solids: what makes a knot hold. The thread's smooth curve (thread_curve.h) is sampled; a sample
/// pressed nearer to another part of the curve than one diameter is pushed off along the line between them and rubs with Coulomb friction.
///
/// Normal force: the thread is laterally compressible, `stiffness` newtons per metre of thread and metre of squeeze, stiffening toward
/// half a diameter; the force on a crossing then grows as Hertz's (power 1.5). Friction: an elastic bond that is carried from step to step
/// and gives way at mu N, so that what sticks does not creep. Direction and partner of a contact are those at the start of a step, and it
/// is looked for ahead along the relative motion: a pair cannot change sides within a step, however fast.
/// All forces are linearised into the strand's own Newton iteration and solved with it, directly (coupled_solve.h). Physics thread; no heap.
#include <span>
#include <vector>

#include "sim/strand/coupled_solve.h"
#include "sim/strand/giving_tools.h"
#include "sim/strand/nearest_places.h"
#include "sim/strand/piece_spheres.h"
#include "sim/strand/strand_model.h"
#include "sim/strand/strand_state.h"
#include "sim/strand/thread_curve.h"
#include "sim/strand/thread_tie.h"

namespace halsted {

inline constexpr int kFewestSamples = 4, kMostSamples = PointRow::kMost;   // per piece, by its length
inline constexpr int kPiecesPerChunk = 8;      // in the search

struct ThreadContactParams {
  double friction = 0.30;                      // [1] thread on thread, braided; 0.20 monofilament (physics.md D, design)
  double stiffness = 5e8;                      // [N/m^2] lateral modulus of a braid, about 0.5 GPa over the width (design)
  double breakingTension = 17.4;               // [N] USP knot-pull minimum, 3-0 absorbable synthetic (physics.md D)
};

/// A solid that the thread lies against: a capsule, with its ends at the start of the step.
struct ThreadSolid {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();     // [m] now
  Vec3 fromA = Vec3::Zero(), fromB = Vec3::Zero();   // [m] at the start of the step
  double radius = 0.0, friction = 0.2;         // [m], [1]
  double freeFrom = 0.0, freeTo = -1.0;        // [m] coordinates of the thread that pass through it: what jaws hold between them
  int owner = -1;                              // the hand that moves it and gives way with it (giving_tools.h); -1: it stands
};

/// Kept from step to step.
struct ThreadContact {
  std::int32_t sample = -1;                    // kMostSamples per piece
  std::int32_t partner = -1;                   // piece of the curve, or -1 - solid
  double place = 0.0;                          // [1] on the partner piece
  double normalForce = 0.0;                    // [N]
  Vec3 friction = Vec3::Zero();                // [N] tangential, on the sample
};

struct ThreadContactState {
  static constexpr int kMaxContacts = 1536;
  std::array<ThreadContact, kMaxContacts> contacts{};
  std::int32_t count = 0;
  std::int32_t dropped = 0;                    // contacts that found no room, ever
  std::vector<double> drag;                    // [1/s] per node, on its neighbours while it snaps (strand_trust.h)
  std::vector<Vec3> set;                       // [m] per node but the two ends, empty where thread is elastic (thread_bending.h)
  std::vector<std::uint8_t> cut;               // [1] per segment: 1 where the thread has broken or was cut through
};

/// One contact during a solve. Partner weights are zero on a solid.
struct TouchingPoint {
  CurveWeights sample, partner;
  bool solid = false;
  int owner = -1;                              // of the solid
  Vec3 normal = Vec3::UnitX();                 // [1] toward the sample
  Vec3 anchor = Vec3::Zero(), start = Vec3::Zero();   // [m] solid's surface axis now; sample minus partner when the step began
  Vec3 carried = Vec3::Zero();                 // [N] friction at the start
  double stiffness = 0.0, reach = 0.0, coefficient = 0.0;   // [N/m]; [m] distance at which they touch; [1]
  double normalForce = 0.0;                    // [N] at the last iterate
  Vec3 friction = Vec3::Zero();                // [N] at the last iterate
  ThreadContact record;
};

/// A contact that a Newton correction moves (step_share.h): it touches when that begins, or would at its end.
struct MovedContact {
  Vec3 relative = Vec3::Zero(), way = Vec3::Zero();   // [m] sample minus partner before; by which the whole correction changes that
  Vec3 force = Vec3::Zero(), answer = Vec3::Zero();   // [N] before; what the linear model takes off it
  int point = -1;
};

/// A sample and the place on another piece that is nearest to it.
struct NearPair { int piece, sample, partner; double place, gap; };   // [1], [m] between the surfaces

/// A piece of the curve as the search sees it, worked out where it is near another.
struct SampledPiece {
  bool filled = false;                         // in this search
  Vec3 velocity = Vec3::Zero();                // [m/s] of its middle
  PointRow points;
};

struct ThreadContactWork {
  ThreadContactParams params;
  std::span<const ThreadSolid> solids;         // set by the caller before each step
  ThreadTie tie;                               // set by the caller before each step
  CoupledSolve coupled;
  GivingTools hands;                           // what they are, the caller sets before each step
  std::vector<TouchingPoint> points;
  std::vector<MovedContact> moved;             // by the correction under way
  PieceSpheres pieces;
  std::vector<Vec3> chunkCentre;               // [m]
  std::vector<double> chunkRadius, pieceLength;   // [m]; at rest
  std::vector<std::int32_t> samples;           // of each piece: no farther apart than the thread is thick
  std::vector<std::int32_t> firstBeyond;       // after each piece, the first that may touch it
  std::vector<std::int32_t> recordOfSample, nextRecord;
  std::vector<double> tension;                 // [N] at the start of the step
  std::vector<double> allowance;               // [m] per piece: how far it may stray in this step (strand_trust.h)
  std::vector<NearPair> near;                  // what the search found
  std::vector<SampledPiece> sampled;           // per piece
  double fastest = 0.0;                        // [m/s] of any node
  bool coupledStep = false;                    // thread touches thread, or a hand that gives way, in this step
};

/// Both together: what `solveStrand` takes.
struct ThreadTouch {
  ThreadContactState& state;
  ThreadContactWork& work;
};

ThreadContactState restContacts(const StrandModel&);
ThreadContactWork prepareContactWork(const StrandModel&, const ThreadContactParams&);

/// Before the solve: who may touch whom within dt.
void findThreadContacts(const StrandModel&, const StrandState&, double dt, ThreadTouch&);   // [s]

/// Forces and stiffness at an iterate, into the strand's system and the couplings.
void assembleThreadContacts(const std::vector<Vec3>& iterate, BandedMatrix&, std::vector<double>& rhs, ThreadContactWork&);   // [N]

/// After the solve: what is kept for the next step.
void settleThreadContacts(const StrandState&, ThreadTouch&);

/// Force of the thread on a solid, as the last solve left it.  [N]
Vec3 forceOnSolid(const ThreadContactWork&, int solid);

/// The segment that is pulled hardest, if its tension has reached the breaking strength, or -1.
int overloadedSegment(const StrandState&, double breakingTension);   // [N]

}  // namespace halsted
