#pragma once
/// The seam of all stitches together, those kept and the running strand's. Outside the step: it may allocate.
#include <string>
#include <utility>
#include <vector>

#include "sim/join.h"

namespace halsted {

/// As `measureJoin`, over the stretch from the first stitch to the last, all round but the widest gap between two.
JoinMetrics measureWholeSeam(const Model&, const State&);

/// How the stitches of a scene with `thread.spare` lie: their number, spacing, reach, pull and slack (loose: over 3 mm), and the widest gap between the walls from the
/// first to the last. Name with its unit, value; nothing in other scenes.
std::vector<std::pair<std::string, double>> summariseStitches(const Model&, const State&);

}  // namespace halsted
