#include "sim/tissue/tissue.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sim/materials/stable_neo_hookean.h"

namespace halsted {

Lame lame(double youngsModulus, double poissonRatio) {
  return {youngsModulus / (2.0 * (1.0 + poissonRatio)),
          youngsModulus * poissonRatio / ((1.0 + poissonRatio) * (1.0 - 2.0 * poissonRatio))};
}

namespace {

void requirePositive(double value, const char* what) {
  if (!(value > 0.0) || !std::isfinite(value)) throw std::invalid_argument(std::string(what) + " must be positive");
}

void checkParams(const SimParams& p) {
  requirePositive(p.dt, "sim.dt");
  requirePositive(p.tissue.youngsModulus, "tissue.youngs_modulus");
  requirePositive(p.tissue.density, "tissue.density");
  requirePositive(p.tissue.toeStrain, "tissue.toe_strain");
  if (!(p.tissue.stiffening >= 1.0 && p.tissue.stiffening <= 20.0)) {
    throw std::invalid_argument("tissue.stiffening must lie between 1 and 20");
  }
  if (!(p.tissue.poissonRatio > 0.0 && p.tissue.poissonRatio < 0.5)) {
    throw std::invalid_argument("tissue.poisson_ratio must lie between 0 and 0.5");
  }
}

void buildElements(const TetMesh& mesh, double density, TissueModel& m) {
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& v = mesh.tets[t];
    Mat3 edges;
    for (int c = 0; c < 3; ++c) edges.col(c) = mesh.vertices[v[c + 1]] - mesh.vertices[v[0]];
    const double rest = edges.determinant() / 6.0;
    if (!(rest > 0.0)) throw std::invalid_argument("tissue: tet " + std::to_string(t) + " is flat or inverted");
    m.restInverse.push_back(edges.inverse());
    m.restVolume.push_back(rest);
    for (int c = 0; c < 4; ++c) m.mass[v[c]] += density * rest / 4.0;
  }
}

}  // namespace

TissueModel buildTissue(const TetMesh& mesh, const SimParams& params) {
  checkParams(params);
  if (!mesh.cuttable.empty() && params.tissue.solver == TissueSolver::kShapeMatching)
    throw std::invalid_argument("tissue.solver: shape_matching has no tissue that can be cut; projective and xpbd have");
  TissueModel m;
  m.solver = params.tissue.solver;
  m.dt = params.dt;
  m.gravity = params.tissue.bedded ? Vec3(Vec3::Zero()) : params.gravity;
  m.massDamping = params.tissue.massDamping;
  const Lame material = lame(params.tissue.youngsModulus, params.tissue.poissonRatio);
  m.material = {material.mu, material.lambda, m.solver == TissueSolver::kProjective ? params.tissue.stiffening : 1.0, params.tissue.toeStrain};
  m.tets = mesh.tets;
  m.rest = mesh.vertices;
  m.mass.assign(mesh.vertices.size(), 0.0);
  m.isFixed.assign(mesh.vertices.size(), 0);
  for (int v : mesh.fixed) m.isFixed[v] = 1;
  buildElements(mesh, params.tissue.density, m);
  for (std::size_t i = 0; i < m.mass.size(); ++i) {
    if (!(m.mass[i] > 0.0)) throw std::invalid_argument("tissue: particle " + std::to_string(i) + " belongs to no tet");
  }
  buildProjective(m);
  if (m.solver == TissueSolver::kXpbd) buildXpbd(m, params.tissue);
  if (m.solver == TissueSolver::kShapeMatching) buildShapeMatching(m, params.tissue);
  return m;
}

TissueState restState(const TissueModel& m) {
  TissueState s;
  s.position = m.rest;
  s.velocity.assign(m.rest.size(), Vec3::Zero());
  const std::size_t clusters = m.shape.clusterStart.empty() ? 0 : m.shape.clusterStart.size() - 1;
  const std::size_t padded = static_cast<std::size_t>(m.projective.groups) * ProjectiveModel::kLanes;
  s.rotation.assign(m.solver == TissueSolver::kShapeMatching ? clusters : padded, Quat::Identity());
  s.pressure.assign(padded, 0.0);
  s.rodForce.assign(m.rest.size(), Vec3::Zero());
  return s;
}

TissueWork prepareWork(const TissueModel& m) {
  TissueWork w;
  w.previous.resize(m.rest.size());
  w.target.resize(m.rest.size());
  w.rows.resize(m.rest.size() * 4);
  const std::size_t shared = (m.shape.gather.shared.size() + m.shape.spread.shared.size()) / 2;
  w.scratch.resize(std::max(static_cast<std::size_t>(m.projective.groups) * 12 * ProjectiveModel::kLanes,
                            (2 * m.rest.size() + shared + 2) * ShapeMatchingModel::kMap));   // a map per particle, cluster and sum, two empty
  return w;
}

void predictTissue(const TissueModel& m, std::span<const Vec3> force, TissueState& s, TissueWork& w) {
  std::copy(s.position.begin(), s.position.end(), w.previous.begin());
  switch (m.solver) {
    case TissueSolver::kProjective: predictProjective(m, force, s, w); break;
    case TissueSolver::kXpbd: predictXpbd(m, force, s, w); break;
    case TissueSolver::kShapeMatching: predictShapeMatching(m, force, s, w); break;
  }
}

void applyForceChange(const TissueModel& m, std::span<const Vec3> change, TissueState& s, TissueWork& w) {
  const ProjectiveModel& p = m.projective;
  for (int i = 0; i < p.size; ++i) {
    double* row = &w.rows[4 * p.permutation[i]];
    const Vec3 f = m.isFixed[i] ? Vec3::Zero() : change[i];
    row[0] = f.x(); row[1] = f.y(); row[2] = f.z(); row[3] = 0.0;
  }
  solveFactor(p, w.rows.data());
  for (int i = 0; i < p.size; ++i) {
    const double* u = &w.rows[4 * p.permutation[i]];
    if (!m.isFixed[i]) s.position[i] += Vec3(u[0], u[1], u[2]);
  }
}

void finishTissue(const TissueModel& m, TissueState& s, const TissueWork& w) {
  for (std::size_t i = 0; i < s.position.size(); ++i) s.velocity[i] = (s.position[i] - w.previous[i]) / m.dt;
}

double elasticEnergy(const TissueModel& m, const TissueState& s) {
  double sum = 0.0;                                                    // [J]
  for (std::size_t t = 0; t < m.tets.size(); ++t) {
    if (!s.gone.empty() && s.gone[t]) continue;
    Mat3 edges;
    for (int c = 0; c < 3; ++c) edges.col(c) = s.position[m.tets[t][c + 1]] - s.position[m.tets[t][0]];
    const Mat3 F = edges * m.restInverse[t];
    sum += m.restVolume[t] * (m.solver == TissueSolver::kXpbd ? energyDensity(StableNeoHookean{m.material.mu, m.material.lambda}, F)
                                                              : energyDensity(m.material, F));
  }
  return sum;
}

}  // namespace halsted
