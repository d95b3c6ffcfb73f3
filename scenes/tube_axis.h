#pragma once
/// The centreline of a tube, centred in its cross-sections, and which part of it is usable.
#include "scenes/centreline.h"
#include "scenes/tube_section.h"

namespace halsted::scenes {

struct TubeAxis {
  Centreline line;
  double radius = 0.0;             // [m] median of the sections
  double first = 0.0, last = 0.0;  // [m] along the line: between them the wall closes round it
};

/// Throws InputError when the surface is not a tube or its radius is not a colon's at this scale.
TubeAxis tubeAxis(const Surface&, const TubeSlicer&);

/// The plane across the line at `distance`; normal along increasing distance.
SectionFrame planeAt(const Centreline&, double distance);  // [m]

}  // namespace halsted::scenes
