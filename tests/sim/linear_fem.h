#pragma once
/// Reference for the punch: static linear elasticity on linear tets, solved once with conjugate gradients. It tells how much of a
/// difference from a closed form is the mesh's and how much the solver's.
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "sim/tissue/tissue_model.h"

namespace halsted {

/// Displacements given per degree of freedom (3 particle + axis); the others are free of load.
struct Support {
  std::vector<char> given;                     // 1: `value` holds
  Eigen::VectorXd value;                       // [m]
};

inline Eigen::SparseMatrix<double> linearStiffness(const TetMesh& mesh, const Lame& material) {   // [N/m]
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& tet : mesh.tets) {
    Mat3 edges;
    for (int c = 0; c < 3; ++c) edges.col(c) = mesh.vertices[tet[c + 1]] - mesh.vertices[tet[0]];
    const Mat3 inverse = edges.inverse();
    const double volume = edges.determinant() / 6.0;                   // [m^3]
    Vec3 g[4];                                                         // [1/m]
    for (int c = 0; c < 3; ++c) g[c + 1] = inverse.row(c);
    g[0] = -(g[1] + g[2] + g[3]);
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) {
        const Mat3 k = volume * (material.lambda * g[a] * g[b].transpose() + material.mu * g[b] * g[a].transpose() +
                                 material.mu * g[a].dot(g[b]) * Mat3::Identity());
        for (int e = 0; e < 9; ++e) entries.emplace_back(3 * tet[a] + e / 3, 3 * tet[b] + e % 3, k(e / 3, e % 3));
      }
  }
  const int n = 3 * static_cast<int>(mesh.vertices.size());
  Eigen::SparseMatrix<double> stiffness(n, n);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

/// Reaction forces at every degree of freedom; zero where it is free.  [N]
inline Eigen::VectorXd reactions(const TetMesh& mesh, const Lame& material, const Support& support) {
  const Eigen::SparseMatrix<double> stiffness = linearStiffness(mesh, material);
  std::vector<int> index(support.given.size(), -1);
  int free = 0;
  for (std::size_t i = 0; i < index.size(); ++i)
    if (!support.given[i]) index[i] = free++;
  const Eigen::VectorXd load = -(stiffness * support.value);           // [N]
  Eigen::VectorXd rhs(free);                                           // [N]
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < stiffness.outerSize(); ++c) {
    if (index[c] < 0) continue;
    rhs[index[c]] = load[c];
    for (Eigen::SparseMatrix<double>::InnerIterator it(stiffness, c); it; ++it)
      if (index[it.row()] >= 0) entries.emplace_back(index[it.row()], index[c], it.value());
  }
  Eigen::SparseMatrix<double> reduced(free, free);
  reduced.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(1e-8);
  solver.compute(reduced);
  const Eigen::VectorXd x = solver.solve(rhs);                         // [m]
  Eigen::VectorXd displacement = support.value;                        // [m]
  for (std::size_t i = 0; i < index.size(); ++i)
    if (index[i] >= 0) displacement[static_cast<int>(i)] = x[index[i]];
  return stiffness * displacement;
}

}  // namespace halsted
