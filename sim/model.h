#pragma once
/// What a step never changes. Built once by `buildModel`, then shared read-only between threads.
#include <array>
#include <vector>

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
  TissueModel tissue;                          // solver data: masses, factor, inverse
  StrandModel strand;                          // thread and needle: masses, rest lengths, arc samples
  std::vector<ProcedureStep> procedure;
};

/// Throws std::invalid_argument naming the parameter when a value makes no physical sense.
Model buildModel(const SimParams&, TetMesh, std::vector<ProcedureStep>);

int tissueParticles(const Model&);
int threadNodes(const Model&);

}  // namespace halsted
