#pragma once
/// Two bowel ends on their way to being one: how far apart their edges and their outer walls are along the sewn stretch, and how far the
/// edges are turned in. A step's measurement, no physics. Physics thread; no heap.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/bowels.h"
#include "sim/contact/surface.h"
#include "sim/strand/strand_state.h"

namespace halsted {

struct Model;
struct State;

/// Built at load time. Per bowel and rim vertex: the column of outer wall behind it, as far as a stitch reaches.
struct EdgeColumn {
  static constexpr int kMost = 4;
  int count = 0;
  std::array<int, kMost> vertex{};             // outer wall, the rim's own first, then deeper ones
  std::array<int, kMost> facing{};             // nearest vertex of the other bowel at rest: where the search for its surface starts
  int base = 0, deep = 0;                      // two outer vertices behind: the wall's own direction
  int lumen = 0;                               // on the mucosa at the rim
  int inner = 0;                               // opposite to `base` on the mucosa
};

struct JoinModel {
  std::array<std::vector<EdgeColumn>, 2> columns;   // of bowels 0 and 1; empty where the scene has not two of them
  double restGap = 0.0;                        // [m] between the outer walls at rest
  bool present() const { return !columns[0].empty(); }
};

/// What is written down of it. Part of `SeamMetrics`.
struct JoinMetrics {
  std::int32_t crossings = 0;                  // stretches of thread from one bowel to the other
  double rimGap = 0.0;                         // [m] largest distance from edge to edge along the sewn stretch
  double wallGap = 0.0;                        // [m] the same between the outer walls near the edges: what leaks
  double inversion = 0.0;                      // [1] sine of the edges' mean turn toward their lumen, since rest
  double sewnShare = 0.0;                      // [1] of the circumference from the first stitch to the last
  double tailDifference = 0.0;                 // [m] how uneven the thread's two ends are
};

JoinModel buildJoin(const TetMesh&, const Bowels&, const SurfaceModel&);
JoinMetrics measureJoin(const Model&, const State&);

/// Bowel in which a hole lies.
int bowelOf(const Model&, const Hole&);

}  // namespace halsted
