#pragma once
/// Points of a bowel's wall by angle and depth, as a surgeon would name them. Load time.
#include "sim/model.h"
#include "sim/suture/tissue_point.h"

namespace halsted::app {

enum class WallSide { kSerosa = 0, kMucosa = 1 };

/// `turn` [1]: share of the way round the bowel, as the mesh counts it; `depth` [m]: along the wall from the rim. Throws std::out_of_range
/// where the wall does not reach.
TissuePoint wallPoint(const Model&, int bowel, WallSide, double turn, double depth);   // [1] [m]

}  // namespace halsted::app
