#pragma once
/// Thread wound round a tool, as paper 003 section 2.4 finds it: the nodes that touch the tool are projected onto the plane normal to it,
/// each pair of neighbours is tested against every later pair, and a crossing is a loop when (1) the tool lies inside it by the even-odd
/// rule and (2) the loop's two ends are near each other in space. The paper's nodes collide with the tool and its ends are one pair apart; here
/// whoever asks says how near is near. Thread whose strands do not cross, as a single turn held open, is not wound. Pure functions; + - * / only.
#include <limits>
#include <span>

#include "sim/types.h"

namespace halsted {

struct ToolAxis {
  Vec3 tip = Vec3::Zero();                     // [m]
  Vec3 along = Vec3::UnitZ();                  // [1] unit, from the tip to the handle
  double near = std::numeric_limits<double>::infinity();     // [m] from the axis: what is no farther touches the tool
  double length = std::numeric_limits<double>::infinity();   // [m] from the tip, of what of it can be wound with
};

struct ToolLoop {
  int first = -1, last = -1;                   // nodes of the loop; -1 when there is none
  int turns = 0;                               // [1] of the loop about the axis, signed
  bool crosses = false, closed = false;        // its two strands cross, seen along the tool; check 2
  bool encirclesTool() const { return turns % 2 != 0; }   // check 1
  bool valid() const { return crosses && encirclesTool() && closed; }
};

/// The first valid loop along the thread; when none is valid, one that crosses, if possible round the tool. Between its ends a loop may
/// stand off the tool. `reach`: check 2's distance.
ToolLoop findToolLoop(std::span<const Vec3> nodes, const ToolAxis&, double reach);   // [m]

/// Signed turns of all valid loops, one after the other along the thread.
int woundTurns(std::span<const Vec3> nodes, const ToolAxis&, double reach);   // [m]

}  // namespace halsted
