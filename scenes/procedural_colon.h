#pragma once
/// An open colon end without a data file: haustra between three taeniae, round at the rim. Deterministic to the bit.
#include "sim/mesh.h"
#include "sim/params.h"

namespace halsted::scenes {

/// Rim centred at the origin facing +z, tube running to -z, far end fixed. `params` are taken as checked by the scene reader.
TetMesh proceduralColon(const AnatomyParams& params);

}  // namespace halsted::scenes
