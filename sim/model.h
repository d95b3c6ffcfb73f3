#pragma once
/// What a step never changes. Built once by `buildModel`, then shared read-only between threads.
#include <array>
#include <vector>

#include "sim/bowels.h"
#include "sim/contact/surface.h"
#include "sim/join.h"
#include "sim/mesh.h"
#include "sim/params.h"
#include "sim/procedure.h"
#include "sim/tissue/tissue_model.h"
#include "sim/strand/strand_model.h"
#include "sim/types.h"

namespace halsted {

struct Model {
  SimParams params;
  TetMesh mesh;
  SurfaceModel surface;                        // neighbours and owners on the tissue's surface
  TissueModel tissue;                          // solver data: masses, factor, inverse
  StrandModel strand;                          // thread and needle: masses, rest lengths, arc samples
  std::vector<ProcedureStep> procedure;
  Bowels bowels;                               // which end each vertex belongs to, and its rim
  JoinModel join;                              // of a scene with two ends
  double restOpening = 0.0;                    // [m^2] area of the rim's outline at rest
};

/// Throws std::invalid_argument naming the parameter when a value makes no physical sense.
Model buildModel(const SimParams&, TetMesh, std::vector<ProcedureStep>);

int tissueParticles(const Model&);
int threadNodes(const Model&);

}  // namespace halsted
