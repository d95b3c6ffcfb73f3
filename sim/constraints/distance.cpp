#include "sim/constraints/distance.h"

#include <cmath>

namespace halsted {
namespace {

/// Two particles in one spot have no direction to part in: below this they are left alone.
constexpr double kShortest = 1e-12;            // [m]

template <bool kKeepMultiplier>
void sweep(const DistanceConstraints& set, double h, Particles& particles, double* multiplier) {   // h [s], multiplier [N s^2]
  const double perSquare = 1.0 / (h * h);      // [1/s^2]
  const int count = size(set);
  for (int c = 0; c < count; ++c) {
    Particle& a = particles[set.particles[c][0]];
    Particle& b = particles[set.particles[c][1]];
    const double dx = b.position.x() - a.position.x(), dy = b.position.y() - a.position.y(), dz = b.position.z() - a.position.z();   // [m]
    const double length = std::sqrt(dx * dx + dy * dy + dz * dz);      // [m]
    const double alpha = set.compliance[c] * perSquare;                // [1/kg]
    const double weight = a.inverseMass + b.inverseMass + alpha;       // [1/kg]
    if (!(length > kShortest) || !(weight > 0.0)) continue;
    double change = set.restLength[c] - length;                        // [m] becomes [N s^2]
    if constexpr (kKeepMultiplier) change -= alpha * multiplier[c];
    change /= weight;
    if constexpr (kKeepMultiplier) multiplier[c] += change;
    const double scale = change / length, sa = a.inverseMass * scale, sb = b.inverseMass * scale;   // [1]
    a.position.x() -= sa * dx; a.position.y() -= sa * dy; a.position.z() -= sa * dz;
    b.position.x() += sb * dx; b.position.y() += sb * dy; b.position.z() += sb * dz;
  }
}

}  // namespace

int size(const DistanceConstraints& set) { return static_cast<int>(set.particles.size()); }

void project(const DistanceConstraints& set, double h, Particles& particles) { sweep<false>(set, h, particles, nullptr); }

void project(const DistanceConstraints& set, double h, Particles& particles, std::span<double> multiplier) {
  sweep<true>(set, h, particles, multiplier.data());
}

double energy(const DistanceConstraints& set, const Particles& particles) {
  double sum = 0.0;                            // [J]
  for (int c = 0; c < size(set); ++c) {
    if (set.compliance[c] <= 0.0) continue;
    const auto& [a, b] = set.particles[c];
    const double stretch = (particles[b].position - particles[a].position).norm() - set.restLength[c];   // [m]
    sum += 0.5 * stretch * stretch / set.compliance[c];
  }
  return sum;
}

DistanceConstraints makeDistanceConstraints(const std::vector<std::array<int, 2>>& pairs, const Particles& particles, double compliance) {
  DistanceConstraints set;
  for (int c : colourOrder(pairs)) {
    set.particles.push_back(pairs[c]);
    set.restLength.push_back((particles[pairs[c][1]].position - particles[pairs[c][0]].position).norm());
    set.compliance.push_back(compliance);
  }
  return set;
}

}  // namespace halsted
