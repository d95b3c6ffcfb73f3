#pragma once
/// Thread wound round a tool, as paper 003 section 2.4 finds it: the nodes that touch the tool are projected onto the plane normal to it,
/// each pair of neighbours is tested against every later pair, and a crossing is a loop when (1) the tool lies inside it by the even-odd
/// rule and (2) the loop's two ends are no farther apart in space than one pair. Pure functions; + - * / only.
#include <span>

#include "sim/types.h"

namespace halsted {

struct ToolAxis {
  Vec3 tip = Vec3::Zero();                     // [m]
  Vec3 along = Vec3::UnitZ();                  // [1] unit, from the tip to the handle
};

struct ToolLoop {
  int first = -1, last = -1;                   // nodes of the loop; -1 when there is none
  bool crosses = false, encirclesTool = false, closed = false;   // what was found; both checks
  bool valid() const { return crosses && encirclesTool && closed; }
};

/// The first valid loop along the nodes; when none is valid, one that crosses, if possible round the tool. `reach`: check 2's distance.
ToolLoop findToolLoop(std::span<const Vec3> touching, const ToolAxis&, double reach);   // [m]

/// Signed whole turns about the axis: how often the thread passes the half plane on one side of it.
int turnsAbout(std::span<const Vec3> nodes, const ToolAxis&);

}  // namespace halsted
