#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <stdexcept>

#include "sim/lane_math.h"
#include "sim/tissue/tissue_model.h"

namespace halsted {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Gradients of the four shape functions [1/m]: rows of the inverse edge matrix, and minus their sum for corner 0.
std::array<Vec3, 4> shapeGradients(const Mat3& restInverse) {
  const Vec3 g1 = restInverse.row(0), g2 = restInverse.row(1), g3 = restInverse.row(2);
  return {-(g1 + g2 + g3), g1, g2, g3};
}

Sparse systemMatrix(const TissueModel& m) {
  const int n = static_cast<int>(m.mass.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(m.tets.size() * 16 + m.mass.size());
  for (int i = 0; i < n; ++i) {
    const double inertia = m.mass[i] * (1.0 / (m.dt * m.dt) + m.massDamping / m.dt);   // [N/m]
    entries.emplace_back(i, i, m.isFixed[i] ? 1.0 : inertia);
  }
  for (std::size_t t = 0; t < m.tets.size(); ++t) {
    const auto g = shapeGradients(m.restInverse[t]);
    const double weight = 2.0 * m.material.stiffening * m.material.mu * m.restVolume[t];        // [J] of the stiffest slope: never overshoots
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        const int i = m.tets[t][a], j = m.tets[t][b];
        if (m.isFixed[i] || m.isFixed[j]) continue;
        entries.emplace_back(i, j, weight * g[a].dot(g[b]));
      }
    }
  }
  Sparse a(n, n);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

void copyFactor(const Sparse& a, ProjectiveModel& p) {
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> ldlt(a);
  if (ldlt.info() != Eigen::Success) throw std::invalid_argument("tissue: the stiffness matrix cannot be factored");
  const Sparse lower = ldlt.matrixL();
  const Eigen::VectorXd diagonal = ldlt.vectorD();
  p.permutation.resize(p.size);
  for (int i = 0; i < p.size; ++i) p.permutation[i] = ldlt.permutationP().indices()[i];
  FactorColumns columns;
  columns.start.assign(1, 0);
  for (int j = 0; j < p.size; ++j) {
    if (!(diagonal[j] > 0.0)) throw std::invalid_argument("tissue: the stiffness matrix is not positive definite");
    for (Sparse::InnerIterator it(lower, j); it; ++it) {
      if (it.row() <= j) continue;
      columns.row.push_back(static_cast<int>(it.row()));
      columns.value.push_back(it.value());
    }
    columns.start.push_back(static_cast<int>(columns.row.size()));
    p.inverseDiagonal.push_back(1.0 / diagonal[j]);
  }
  layOutFactor(columns, p);
}

/// Three columns of the inverse at a time through the same solve that the step uses.
void buildInverse(const TissueModel& m, ProjectiveModel& p) {
  const std::size_t n = static_cast<std::size_t>(p.size);
  p.inverse.assign(n * n, 0.0);
  std::vector<double> rows(n * 4);
  for (int first = 0; first < p.size; first += 3) {
    std::fill(rows.begin(), rows.end(), 0.0);
    for (int k = 0; k < 3 && first + k < p.size; ++k) {
      if (!m.isFixed[first + k]) rows[static_cast<std::size_t>(p.permutation[first + k]) * 4 + k] = 1.0;
    }
    solveFactor(p, rows.data());
    for (int k = 0; k < 3 && first + k < p.size; ++k) {
      double* line = &p.inverse[static_cast<std::size_t>(first + k) * n];
      for (std::size_t i = 0; i < n; ++i) line[i] = m.isFixed[i] ? 0.0 : rows[static_cast<std::size_t>(p.permutation[i]) * 4 + k];
    }
  }
  for (int i = 0; i < p.size; ++i) p.self.push_back(compliance(p, i, i));
}

void buildLanes(const TissueModel& m, ProjectiveModel& p) {
  constexpr int lanes = ProjectiveModel::kLanes;
  const int tets = static_cast<int>(m.tets.size());
  p.groups = (tets + lanes - 1) / lanes;
  p.laneVertex.resize(p.groups * 4 * lanes);
  p.laneRestInverse.resize(p.groups * 9 * lanes);
  p.laneVolume.resize(p.groups * lanes);
  for (int slot = 0; slot < p.groups * lanes; ++slot) {
    const int t = slot < tets ? slot : tets - 1, g = slot / lanes, lane = slot % lanes;
    for (int c = 0; c < 4; ++c) p.laneVertex[(g * 4 + c) * lanes + lane] = m.tets[t][c];
    for (int e = 0; e < 9; ++e) p.laneRestInverse[(g * 9 + e) * lanes + lane] = m.restInverse[t](e / 3, e % 3);
    p.laneVolume[g * lanes + lane] = slot < tets ? m.restVolume[t] : 0.0;
  }
}

void buildGather(const TissueModel& m, ProjectiveModel& p) {
  constexpr int lanes = ProjectiveModel::kLanes;
  std::vector<std::vector<int>> of(p.size);
  for (std::size_t t = 0; t < m.tets.size(); ++t) {
    const int g = static_cast<int>(t) / lanes, lane = static_cast<int>(t) % lanes;
    for (int c = 0; c < 4; ++c) of[m.tets[t][c]].push_back((g * 4 + c) * 3 * lanes + lane);
  }
  p.cornerStart.assign(1, 0);
  for (const auto& list : of) {
    p.corner.insert(p.corner.end(), list.begin(), list.end());
    p.cornerStart.push_back(static_cast<int>(p.corner.size()));
  }
}

}  // namespace

void buildProjective(TissueModel& m) {
  ProjectiveModel p;
  p.size = static_cast<int>(m.mass.size());
  copyFactor(systemMatrix(m), p);
  p.wide = widestLanes() == LanePath::kWide;
  buildInverse(m, p);
  buildLanes(m, p);
  buildGather(m, p);
  m.projective = std::move(p);
}

}  // namespace halsted
