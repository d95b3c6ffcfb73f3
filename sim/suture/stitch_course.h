#pragma once
/// The visible course of a tied stitch: its tails over the knot to the holes, kept where they lay over the wall. For pictures only.
#include <span>

#include "sim/exchange.h"
#include "sim/suture/tied_stitches.h"

namespace halsted {

struct TiedLoop;

/// Writes how the running strand lies, trimmed beyond the knot, into a stitch made of it.
void keepCourse(const Model&, const State&, const TiedLoop&, TiedStitch&);

/// From the end of one tail through the knot, the holes and the knot to the end of the other, as the tissue lies.  [m]
void courseOf(const Model&, const TiedStitch&, std::span<const Vec3> tissue, std::span<Vec3, kStitchPoints> course);

}  // namespace halsted
