#include "sim/model.h"

#include <cmath>
#include <stdexcept>


namespace halsted {
namespace {

void checkTool(const ToolParams& t) {
  const auto positive = [](double v, const char* what) {
    if (!(v > 0.0) || !std::isfinite(v)) throw std::invalid_argument(std::string("tool: ") + what + " must be positive");
  };
  positive(t.jawLength, "jaw_length");
  positive(t.jawRadius, "jaw_radius");
  positive(t.shaftRadius, "shaft_radius");
  positive(t.shaftLength, "shaft_length");
  positive(t.couplingStiffness, "coupling_stiffness");
}

void buildSuture(const SimParams& params, TetMesh mesh, Model& m) {
  if (mesh.rim.size() < 3) throw std::invalid_argument("anatomy: the mesh has no open rim");
  for (const ToolParams& t : params.tools) checkTool(t);
  if (!(params.anvil.radius >= 0.0)) throw std::invalid_argument("anvil.radius must not be negative");
  m.tissue = buildTissue(mesh, params);
  m.surface = buildSurface(mesh);
  m.strand = buildStrand(params);
  m.bowels = findBowels(mesh);
  m.join = buildJoin(mesh, m.bowels, m.surface);
  m.mesh = std::move(mesh);
  m.restOpening = enclosedArea(m.bowels.rim[0], m.mesh.vertices);
}

}  // namespace

Model buildModel(const SimParams& params, Anatomy anatomy, std::vector<ProcedureStep> procedure) {
  if (procedure.size() > kMaxProcedureSteps) throw std::invalid_argument("procedure: more steps than fit");
  Model m;
  m.params = params;
  m.procedure = std::move(procedure);
  switch (params.model) {
    case ModelKind::kSuture: buildSuture(params, std::move(anatomy.mesh), m); break;
    case ModelKind::kNeedling: m.body = buildBody(params, anatomy.body); break;
  }
  return m;
}

int tissueParticles(const Model& m) { return m.body ? netPoints(m.body->needling) : static_cast<int>(m.mesh.vertices.size()); }
int threadNodes(const Model& m) { return m.strand.nodes; }

}  // namespace halsted
