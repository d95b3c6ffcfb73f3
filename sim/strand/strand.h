#pragma once
/// One implicit step of thread and needle, solved directly in linear time (physics.md 0.1, B3; Deul et al. 2018).
/// Everything that touches the strand (holes in the tissue, jaws, contacts) is a `StrandLink`: a linear spring to a point.
/// Physics thread; no heap.
#include <array>
#include <span>
#include <vector>

#include "sim/strand/banded.h"
#include "sim/strand/strand_model.h"
#include "sim/strand/strand_state.h"

namespace halsted {

/// Pulls the strand's material point `coordinate`:  f = force0 + stiffness (anchor - x(coordinate)).
struct StrandLink {
  double coordinate = 0.0;                     // [m]
  Vec3 anchor = Vec3::Zero();                  // [m]
  Mat3 stiffness = Mat3::Zero();               // [N/m] symmetric, positive semi-definite
  Vec3 force0 = Vec3::Zero();                  // [N] on the strand
  Vec3 force = Vec3::Zero();                   // [N] on the strand, written by the solve
};

/// Turns the needle toward an orientation: torque = stiffness * (rotation from here to `target`).
struct NeedleTurnLink {
  Quat target = Quat::Identity();
  double stiffness = 0.0;                      // [N m/rad]
};

struct ThreadTouch;                            // sim/strand/thread_contacts.h

struct StrandWork {
  static constexpr int kMaxLinks = 384;
  BandedMatrix matrix;
  std::vector<double> rhs, load;               // [N], then the solution [m]; [N] that it answers. Nodes, needle, hands that give way
  std::vector<Vec3> iterate, inertial;         // [m] Newton iterate; where inertia alone would go
  std::array<StrandLink, kMaxLinks> links;
  int linkCount = 0;
  std::array<NeedleTurnLink, kHands> turns;
  int turnCount = 0;
  int iterations = 0;                          // Newton iterations of the last solve
  bool settled = true;                         // did they come to rest? Else the tensions are those of a rough guess
};

StrandWork prepareWork(const StrandModel&);
/// Hanging straight down from the needle's swage, at rest.
StrandState restState(const StrandModel&, const Pose& needle);
/// The same with a strand that has been used: nothing is left of how it lay, in no hole and against nothing; bites begun stay counted. No heap.
void layAtRest(const StrandModel&, const Pose& needle, StrandState&);

/// False when the table is full: the caller counts it.
bool addLink(StrandWork&, const StrandLink&);

/// Advances by dt under gravity and the links in `work`. False if the system could not be solved: then nothing has moved, but the tensions are those of
/// the last iterate that could be, and with `touch` its drag and its count of dropped contacts have changed too.
/// With `touch`, thread also meets thread and the solids named there.
bool solveStrand(const StrandModel&, double dt, const Vec3& gravity, StrandState&, StrandWork&, ThreadTouch* touch = nullptr);   // [s]

/// World position and unit tangent (toward the tip) of a material point; coordinates are clamped to the strand.
Vec3 strandPoint(const StrandModel&, const StrandState&, double coordinate);   // [m]
Vec3 strandTangent(const StrandModel&, const StrandState&, double coordinate);   // [m]
/// Velocity of a material point [m/s].
Vec3 strandVelocity(const StrandModel&, const StrandState&, double coordinate);
/// Tension just on the tail side (`side` < 0) or tip side of a coordinate [N]; zero or more; 0 on the needle.
double strandTension(const StrandModel&, const StrandState&, double coordinate, int side);

}  // namespace halsted
