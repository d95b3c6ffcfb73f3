#include <algorithm>
#include <stdexcept>
#include <string>

#include "sim/tissue/tissue_model.h"

namespace halsted {
namespace {

std::vector<std::vector<int>> edgeNeighbours(const TissueModel& m) {
  std::vector<std::vector<int>> near(m.rest.size());
  for (const auto& tet : m.tets)
    for (int a : tet)
      for (int b : tet)
        if (a != b) near[a].push_back(b);
  for (auto& list : near) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return near;
}

/// The smallest whole number of edge rings with enough particles, then the nearest of these; ties go to the lower index.
std::vector<int> neighbourhood(const TissueModel& m, const std::vector<std::vector<int>>& near, int centre) {
  std::vector<int> found{centre};
  for (std::size_t ringStart = 0; static_cast<int>(found.size()) < ShapeMatchingModel::kMembers;) {
    const std::size_t ringEnd = found.size();
    for (std::size_t i = ringStart; i < ringEnd; ++i)
      for (int next : near[found[i]])
        if (std::find(found.begin(), found.end(), next) == found.end()) found.push_back(next);
    if (found.size() == ringEnd) break;        // the whole connected mesh
    ringStart = ringEnd;
  }
  const auto distance = [&](int i) { return (m.rest[i] - m.rest[centre]).squaredNorm(); };
  std::sort(found.begin(), found.end(), [&](int a, int b) {
    const double da = distance(a), db = distance(b);                   // [m^2]
    return da != db ? da < db : a < b;
  });
  if (static_cast<int>(found.size()) > ShapeMatchingModel::kMembers) found.resize(ShapeMatchingModel::kMembers);
  std::sort(found.begin(), found.end());
  return found;
}

void buildClusters(const TissueModel& m, ShapeMatchingModel& s) {
  const auto near = edgeNeighbours(m);
  const int particles = static_cast<int>(m.rest.size());
  std::vector<std::vector<int>> owners(m.rest.size());
  s.clusterStart.assign(1, 0);
  for (int c = 0; c < particles; ++c) {
    for (int i : neighbourhood(m, near, c)) {
      s.member.push_back(i);
      owners[i].push_back(c);
    }
    s.clusterStart.push_back(static_cast<int>(s.member.size()));
  }
  s.ownerStart.assign(1, 0);
  for (const auto& list : owners) {
    s.owner.insert(s.owner.end(), list.begin(), list.end());
    s.ownerStart.push_back(static_cast<int>(s.owner.size()));
  }
  std::vector<std::vector<int>> members;
  for (int c = 0; c < particles; ++c) members.emplace_back(s.member.begin() + s.clusterStart[c], s.member.begin() + s.clusterStart[c + 1]);
  s.gather = planSums(members, particles);
  s.spread = planSums(owners, particles);
}

void buildRestShape(const TissueModel& m, ShapeMatchingModel& s) {
  for (const Vec3& x : m.rest) s.origin += x / static_cast<double>(m.rest.size());
  for (std::size_t i = 0; i < m.rest.size(); ++i) {
    const double part = 1.0 / (s.ownerStart[i + 1] - s.ownerStart[i]);   // [1]
    const Vec3 x = part * (m.rest[i] - s.origin);
    s.rest.insert(s.rest.end(), {x.x(), x.y(), x.z(), part});
  }
  s.mass = m.mass;
  const std::size_t clusters = s.clusterStart.size() - 1, lanes = SumPlan::kLists, groups = (clusters + lanes - 1) / lanes;
  s.laneCentre.resize(4 * lanes * groups);
  for (std::size_t k = 0; k < lanes * groups; ++k) {
    const std::size_t c = std::min(k, clusters - 1);   // the last group repeats the last cluster
    Vec3 centre = Vec3::Zero();                // [kg m] until divided
    double mass = 0.0;                         // [kg]
    for (int e = s.clusterStart[c]; e < s.clusterStart[c + 1]; ++e) {
      const int i = s.member[e];
      const double share = s.mass[i] * s.rest[4 * i + 3];              // [kg]
      centre += share * (m.rest[i] - s.origin);
      mass += share;
    }
    centre /= mass;
    const double entries[4] = {centre.x(), centre.y(), centre.z(), 1.0 / mass};
    for (std::size_t e = 0; e < 4; ++e) s.laneCentre[lanes * (4 * (k / lanes) + e) + k % lanes] = entries[e];
  }
}

}  // namespace

void buildShapeMatching(TissueModel& m, const TissueParams& params) {
  if (!(params.resistance > 0.0 && params.resistance <= 1.0)) throw std::invalid_argument("tissue.resistance must lie in (0, 1]");
  if (params.shapeIterations < 1) throw std::invalid_argument("tissue.shape_iterations must be at least 1");
  ShapeMatchingModel s;
  if (params.substeps > 0) s.substeps = params.substeps;
  s.iterations = params.shapeIterations;
  s.resistance = params.resistance;
  s.path = widestLanes();
  buildClusters(m, s);
  buildRestShape(m, s);
  m.shape = std::move(s);
}

}  // namespace halsted
