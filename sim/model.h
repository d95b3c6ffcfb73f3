#pragma once
/// What a step never changes. Built once by `buildModel`, then shared read-only between threads.
#include <array>
#include <optional>
#include <vector>

#include "sim/anatomy.h"
#include "sim/bowels.h"
#include "sim/contact/surface.h"
#include "sim/cutting/cut_plan.h"
#include "sim/join.h"
#include "sim/mesh.h"
#include "sim/needling/body_model.h"
#include "sim/params.h"
#include "sim/procedure.h"
#include "sim/tissue/tissue_model.h"
#include "sim/strand/strand_model.h"
#include "sim/types.h"

namespace halsted {

/// `params.model` says which part is there: the suture's, or the body that is needled. The rest of it is empty.
struct Model {
  SimParams params;
  std::vector<ProcedureStep> procedure;
  // ModelKind::kSuture
  TetMesh mesh;                                // surface and triangleLayer as in `surface`: with the faces that a cut lays bare
  SurfaceModel surface;                        // neighbours and owners on the tissue's surface
  TissueModel tissue;                          // solver data: masses, factor, inverse
  CutPlan cut;                                 // where tissue can be cut
  StrandModel strand;                          // thread and needle: masses, rest lengths, arc samples
  Bowels bowels;                               // which end each vertex belongs to, and its rim
  JoinModel join;                              // of a scene with two ends
  double restOpening = 0.0;                    // [m^2] area of the rim's outline at rest
  // ModelKind::kNeedling
  std::optional<BodyModel> body;
};

/// Throws std::invalid_argument naming the parameter when a value makes no physical sense.
Model buildModel(const SimParams&, Anatomy, std::vector<ProcedureStep>);
inline Model buildModel(const SimParams& p, TetMesh wall, std::vector<ProcedureStep> procedure) {
  return buildModel(p, Anatomy{std::move(wall), {}}, std::move(procedure));
}

int tissueParticles(const Model&);             // of the wall, or mass points of the force nets
int threadNodes(const Model&);

}  // namespace halsted
