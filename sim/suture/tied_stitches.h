#pragma once
/// Stitches that are tied and cut off: closed loops of thread through points of the tissue. Still physics, at a small and constant cost each:
/// a loop of known length that slides without friction through its holes, pulls them together when it is too short for them and never
/// pushes, and tears out past `needle.tear_force`. Where two of its holes lie next to each other its pull is solved with their motion, as if
/// every other loop were pulled as hard. What it leaves out: its thread meets nothing outside the holes, and its knot holds. Physics
/// thread; no heap.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/suture/tissue_point.h"
#include "sim/types.h"

namespace halsted {

struct Model;
struct State;
struct StepOutput;

/// A place over the surface that moves with it: for the picture of thread that lies outside the wall.
struct OverSurface {
  std::int32_t triangle = -1;
  std::array<double, 3> weight{};              // [1] barycentric
  double height = 0.0;                         // [m] along the outward normal
};

struct TiedStitch {
  static constexpr int kMostHoles = 8, kLeg = 5;
  std::int32_t holeCount = 0;
  std::array<TissuePoint, kMostHoles> hole{};  // in the order in which the thread runs through them, round the loop
  std::array<Vec3, kMostHoles> force = zeroVectors<kMostHoles>();   // [N] on the tissue
  std::array<double, kMostHoles * kMostHoles> give{};   // [m/N] compliance between holes
  double shared = 0.0;                         // [m/N] how far the other stitches close this loop when each pulls with a newton, at most
  double length = 0.0;                         // [m] of the loop without tension
  double tension = 0.0;                        // [N] all the way round
  // How its two tails lay when it was cut off, from their ends over the knot to the first and the last hole: seen, not felt. Triangle -1: not known.
  std::array<OverSurface, kLeg> tailLeg{}, tipLeg{};
};

/// Part of `State` of a scene that has them.
struct TiedStitches {
  static constexpr int kMost = 64;
  std::array<TiedStitch, kMost> stitch{};
  std::int32_t count = 0;
  std::int32_t torn = 0;                       // removed again
};

/// Ties a loop of `length` [m] through these holes (two to eight). False when there is no room for another, or the state has none.
bool tieStitch(const Model&, State&, std::span<const TissuePoint> holes, double length);

/// As the tissue lies, this loop bears `tension`: its length and its pull become what they are then.  [m] [N]
void loadStitch(const Model&, std::span<const Vec3> tissue, double tension, TiedStitch&);

/// Length of the shortest loop through a stitch's holes as the tissue lies.  [m]
double loopLength(const Model&, const TiedStitch&, std::span<const Vec3> tissue);   // [m]

/// Adds what every loop pulled with at the end of the last step to the tissue's nodal forces.  [N]
void gatherStitchForces(const Model&, const State&, std::vector<Vec3>& nodal);

/// A stitch with a hole in a tet that is gone has torn out.
void tearStitchesInGone(const Model&, State&, StepOutput&);

/// Solves each loop's tension on the tissue's compliance, adds the change of force to `work.change`, removes what tore out.
void settleStitches(const Model&, State&, StepOutput&);

}  // namespace halsted
