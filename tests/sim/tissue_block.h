#pragma once
/// A block of tissue with the scene's own step and material, driven through the calls that the scene uses.
#include <array>
#include <cmath>
#include <string>

#include "sim/materials/corotated.h"
#include "sim/materials/stable_neo_hookean.h"
#include "sim/tissue/tissue.h"

namespace halsted {

/// The purse-string scene's tissue (SimParams defaults: dt 1 ms, E 120 kPa, nu 0.45, rho 1060), no gravity unless a test sets it.
inline SimParams sceneParams(TissueSolver solver) {
  SimParams params;
  params.gravity.setZero();
  params.tissue.solver = solver;
  return params;
}

struct TissueBlock {
  TetMesh mesh;
  TissueModel model;
  TissueState state;
  TissueWork work;
  std::vector<Vec3> force;                     // [N] per particle

  TissueBlock(TetMesh shape, const SimParams& params)
      : mesh(std::move(shape)), model(buildTissue(mesh, params)), state(restState(model)), work(prepareWork(model)),
        force(model.rest.size(), Vec3::Zero()) {}

  void run(int steps) {
    for (int k = 0; k < steps; ++k) {
      predictTissue(model, force, state, work);
      finishTissue(model, state, work);
    }
  }

  Mat3 deformation(int tet) const {            // F [1]
    Mat3 edges;
    for (int c = 0; c < 3; ++c) edges.col(c) = state.position[model.tets[tet][c + 1]] - state.position[model.tets[tet][0]];
    return edges * model.restInverse[tet];
  }

  /// Energy of the material that the solver stands for.  [J]
  double elastic() const {
    return elasticEnergy(model, state);
  }
  double kinetic() const {                     // [J]
    double sum = 0.0;
    for (std::size_t i = 0; i < model.mass.size(); ++i) sum += 0.5 * model.mass[i] * state.velocity[i].squaredNorm();
    return sum;
  }

  bool finite() const {
    for (std::size_t i = 0; i < state.position.size(); ++i)
      if (!state.position[i].allFinite() || !state.velocity[i].allFinite()) return false;
    for (const Quat& q : state.rotation)
      if (!q.coeffs().allFinite()) return false;
    return true;
  }

  /// Loads the surface with the dead traction P N (first Piola-Kirchhoff stress times rest normal), shared by each triangle's corners.
  void pull(const Mat3& stress) {              // [Pa]
    for (const auto& [a, b, c] : mesh.surface) {
      const Vec3 area = 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);   // [m^2]
      for (int v : {a, b, c}) force[v] += stress * area / 3.0;
    }
  }

  /// Mean position along an axis of the particles that lie on a plane of the rest shape.  [m]
  double meanOnPlane(int axis, double at) const {   // at [m]
    double sum = 0.0;                               // [m]
    int count = 0;
    for (std::size_t i = 0; i < model.rest.size(); ++i) {
      if (std::fabs(model.rest[i][axis] - at) > 1e-9) continue;
      sum += state.position[i][axis];
      ++count;
    }
    return sum / count;
  }
};

inline std::string solverName(TissueSolver solver) {
  const char* const names[] = {"Projective", "Xpbd", "ShapeMatching"};
  return names[static_cast<int>(solver)];
}

}  // namespace halsted
