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
  positive(t.handForce, "hand_force");
}

void checkCautery(const CauteryParams& c) {
  const bool sound = c.power >= 0.0 && c.cuttingEnergy > 0.0 && c.tipRadius > 0.0 && c.reach > 0.0 && c.takeAway > 0.0 && c.crumb >= 0.0;
  if (!sound) throw std::invalid_argument("cautery: cutting_energy, tip_radius, reach and take_away must be positive, power and crumb not negative");
}

/// The mesh of the model has the faces too that a cut lays bare.
void showCutFaces(Model& m) {
  m.mesh.surface = m.surface.triangles;
  m.mesh.triangleLayer.resize(m.surface.triangles.size(), kCutFace);
}

void buildSuture(const SimParams& params, TetMesh mesh, Model& m) {
  if (mesh.rim.size() < 3) throw std::invalid_argument("anatomy: the mesh has no open rim");
  for (const ToolParams& t : params.tools) checkTool(t);
  for (const ToolParams& t : params.second)
    if (t.kind != ToolKind::kNone) checkTool(t);
  checkCautery(params.cautery);
  checkCut(mesh);
  if (!(params.anvil.radius >= 0.0)) throw std::invalid_argument("anvil.radius must not be negative");
  m.tissue = buildTissue(mesh, params);
  m.surface = buildSurface(mesh);
  m.bowels = findBowels(mesh);
  m.cut = planCut(mesh, m.surface, m.bowels);
  m.strand = buildStrand(params);
  m.join = buildJoin(mesh, m.bowels, m.surface);
  m.mesh = std::move(mesh);
  if (m.cut.present()) showCutFaces(m);
  m.restOpening = enclosedArea(m.bowels.rim[0], m.mesh.vertices);
}

}  // namespace

Model buildModel(const SimParams& params, Anatomy anatomy, std::vector<ProcedureStep> procedure) {
  if (procedure.size() > kMaxProcedureSteps) throw std::invalid_argument("procedure: more steps than fit");
  Model m;
  m.params = params;
  // The blade of a pen is as thick as its electrode.
  for (ToolParams* tools : {m.params.tools, m.params.second})
    for (int hand = 0; hand < kHands; ++hand)
      if (tools[hand].kind == ToolKind::kElectrocautery) tools[hand].jawRadius = params.cautery.tipRadius;
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
