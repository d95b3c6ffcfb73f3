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

}  // namespace

Model buildModel(const SimParams& params, TetMesh mesh, std::vector<ProcedureStep> procedure) {
  if (mesh.rim.size() < 3) throw std::invalid_argument("anatomy: the mesh has no open rim");
  if (procedure.size() > kMaxProcedureSteps) throw std::invalid_argument("procedure: more steps than fit");
  for (const ToolParams& t : params.tools) checkTool(t);
  if (!(params.anvil.radius >= 0.0)) throw std::invalid_argument("anvil.radius must not be negative");
  Model m;
  m.params = params;
  m.tissue = buildTissue(mesh, params);
  m.surface = buildSurface(mesh);
  m.strand = buildStrand(params);
  m.bowels = findBowels(mesh);
  m.join = buildJoin(mesh, m.bowels, m.surface);
  m.mesh = std::move(mesh);
  m.procedure = std::move(procedure);
  m.restOpening = enclosedArea(m.bowels.rim[0], m.mesh.vertices);
  return m;
}

int tissueParticles(const Model& m) { return static_cast<int>(m.mesh.vertices.size()); }
int threadNodes(const Model& m) { return m.strand.nodes; }

}  // namespace halsted
