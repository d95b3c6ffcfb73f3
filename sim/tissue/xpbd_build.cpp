#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/constraints/colour_order.h"
#include "sim/tissue/tissue_model.h"

namespace halsted {
namespace {

constexpr int kLanes = XpbdModel::kLanes;
constexpr int kMaxSubsteps = 64;               // above this a step costs more than the millisecond that it simulates
constexpr double kPromise = 0.05;              // [1] DESIGN 6: stretch under load true within 5 %

void appendGroup(const TissueModel& m, const int* tets, int count, XpbdModel& x) {
  const int g = x.groups++;
  x.laneVertex.resize(x.groups * 4 * kLanes);
  x.laneRestInverse.resize(x.groups * 9 * kLanes);
  x.laneInverseVolume.resize(x.groups * kLanes);
  for (int lane = 0; lane < kLanes; ++lane) {
    const int t = tets[std::min(lane, count - 1)];
    x.laneTet.push_back(t);
    for (int c = 0; c < 4; ++c) x.laneVertex[(g * 4 + c) * kLanes + lane] = m.tets[t][c];
    for (int e = 0; e < 9; ++e) x.laneRestInverse[(g * 9 + e) * kLanes + lane] = m.restInverse[t](e / 3, e % 3);
    x.laneInverseVolume[g * kLanes + lane] = 1.0 / m.restVolume[t];
  }
}

void buildGroups(const TissueModel& m, XpbdModel& x) {
  const std::vector<int> colour = colours(m.tets);
  x.order.resize(m.tets.size());
  for (std::size_t t = 0; t < x.order.size(); ++t) x.order[t] = static_cast<int>(t);
  std::stable_sort(x.order.begin(), x.order.end(), [&](int a, int b) { return colour[a] < colour[b]; });
  for (std::size_t i = 0; i < x.order.size();) {
    int count = 1;
    while (count < kLanes && i + count < x.order.size() && colour[x.order[i + count]] == colour[x.order[i]]) ++count;
    appendGroup(m, &x.order[i], count, x);
    i += count;
  }
}

/// Mean over the mass of k / m, with k the stiffness that a particle feels when its neighbours hold still.  [1/s^2]
double stiffnessPerMass(const TissueModel& m) {
  double stiffness = 0.0, mass = 0.0;          // [N/m], [kg]
  for (std::size_t t = 0; t < m.tets.size(); ++t) {
    const Mat3& b = m.restInverse[t];
    const Vec3 sum = b.row(0) + b.row(1) + b.row(2);
    stiffness += m.restVolume[t] * (2.0 * m.material.mu + m.material.lambda) * (b.squaredNorm() + sum.squaredNorm()) / 3.0;
  }
  for (double particle : m.mass) mass += particle;
  return stiffness / mass;
}

}  // namespace

void buildXpbd(TissueModel& m, const TissueParams& params) {
  XpbdModel x;
  buildGroups(m, x);
  x.path = widestLanes();
  const double softening = 0.36 * stiffnessPerMass(m) * m.dt * m.dt;   // [1]
  x.substeps = params.substeps;
  if (x.substeps <= 0) x.substeps = std::clamp(static_cast<int>(std::ceil(std::sqrt(softening / kPromise))), 1, kMaxSubsteps);
  x.stiffnessShortfall = softening / (static_cast<double>(x.substeps) * x.substeps);
  m.xpbd = std::move(x);
}

}  // namespace halsted
