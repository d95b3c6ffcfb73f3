#pragma once
/// What a look at a state shows that hands gone wild must not bring about: a number that is none, thread inside tissue or a tool.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted::app {

/// Is every number of the state a number?
bool finite(const State&);

/// How deep thread lies where it should not: away from its holes in the tissue, away from the place where jaws hold it in a tool.
struct ThreadDepth {
  double tissue = 0.0, tool = 0.0;             // [m] deepest node below a surface
  int inTissue = 0, inTool = 0;                // nodes deeper than `kDeep`
  int inPassed = 0;                            // of those in a tool: in one that has gone through a wall
  int through = 0;                             // times that it goes in by one side of a wall and out by the other, and no hole is there
  int nodes = 0;                               // that were looked at
};
inline constexpr double kDeep = 0.5e-3;        // [m] thread has sunk in: 3 radii of 2-0
ThreadDepth threadDepth(const Model&, const State&);

}  // namespace halsted::app
