#pragma once
/// The rig of haptics/bench under the names that the tests of the loop use.
#include "haptics/bench/rig.h"

namespace halsted::haptics {

using bench::Rig;
using bench::rmsAbove30Hz;
using bench::SoftTissue;
using bench::SpringWall;

}  // namespace halsted::haptics
