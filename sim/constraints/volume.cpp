#include "sim/constraints/volume.h"

namespace halsted {
namespace {

/// Below this the gradient has no direction (all four corners in one line) and the tet is left alone.
constexpr double kSmallestGradient = 1e-60;    // [m^4/kg]

struct Vec { double x, y, z; };                // [m] or [m^2]; plain numbers: the sweep is all arithmetic
inline Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec cross(const Vec& a, const Vec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec at(const Particle& p) { return {p.position.x(), p.position.y(), p.position.z()}; }
inline void move(Particle& p, double scale, const Vec& g) {            // scale [kg/m]
  const double s = p.inverseMass * scale;      // [1/m]
  p.position.x() += s * g.x; p.position.y() += s * g.y; p.position.z() += s * g.z;
}

template <bool kKeepMultiplier>
void sweep(const VolumeConstraints& set, double h, Particles& particles, double* multiplier) {   // h [s], multiplier [Pa s^2]
  const double perSquare = 1.0 / (h * h);      // [1/s^2]
  const int count = size(set);
  for (int c = 0; c < count; ++c) {
    const auto& v = set.particles[c];
    Particle &p0 = particles[v[0]], &p1 = particles[v[1]], &p2 = particles[v[2]], &p3 = particles[v[3]];
    const Vec x0 = at(p0), e1 = at(p1) - x0, e2 = at(p2) - x0, e3 = at(p3) - x0;
    // Six times the gradients; corner 0 takes minus their sum.
    const Vec g1 = cross(e2, e3), g2 = cross(e3, e1), g3 = cross(e1, e2);
    const Vec g0{-(g1.x + g2.x + g3.x), -(g1.y + g2.y + g3.y), -(g1.z + g2.z + g3.z)};
    const double alpha = 36.0 * set.compliance[c] * perSquare;         // [m^4/kg]
    const double weight = p0.inverseMass * dot(g0, g0) + p1.inverseMass * dot(g1, g1) + p2.inverseMass * dot(g2, g2) +
                          p3.inverseMass * dot(g3, g3) + alpha;        // [m^4/kg]
    if (!(weight > kSmallestGradient)) continue;
    double change = 6.0 * set.restVolume[c] - dot(g1, e1);             // [m^3] becomes [Pa s^2 / 6]
    if constexpr (kKeepMultiplier) change -= alpha / 6.0 * multiplier[c];
    change /= weight;
    if constexpr (kKeepMultiplier) multiplier[c] += 6.0 * change;
    move(p0, change, g0);
    move(p1, change, g1);
    move(p2, change, g2);
    move(p3, change, g3);
  }
}

double tetVolume(const std::array<int, 4>& v, const Particles& particles) {
  const Vec x0 = at(particles[v[0]]);
  return dot(cross(at(particles[v[1]]) - x0, at(particles[v[2]]) - x0), at(particles[v[3]]) - x0) / 6.0;
}

}  // namespace

int size(const VolumeConstraints& set) { return static_cast<int>(set.particles.size()); }

void project(const VolumeConstraints& set, double h, Particles& particles) { sweep<false>(set, h, particles, nullptr); }

void project(const VolumeConstraints& set, double h, Particles& particles, std::span<double> multiplier) {
  sweep<true>(set, h, particles, multiplier.data());
}

double energy(const VolumeConstraints& set, const Particles& particles) {
  double sum = 0.0;                            // [J]
  for (int c = 0; c < size(set); ++c) {
    if (set.compliance[c] <= 0.0) continue;
    const double excess = tetVolume(set.particles[c], particles) - set.restVolume[c];   // [m^3]
    sum += 0.5 * excess * excess / set.compliance[c];
  }
  return sum;
}

VolumeConstraints makeVolumeConstraints(const std::vector<std::array<int, 4>>& tets, const Particles& particles, double compliance) {
  VolumeConstraints set;
  for (int c : colourOrder(tets)) {
    set.particles.push_back(tets[c]);
    set.restVolume.push_back(tetVolume(tets[c], particles));
    set.compliance.push_back(compliance);
  }
  return set;
}

}  // namespace halsted
