#include "render/noise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace halsted::render {
namespace {

/// A number in [0, 1] that belongs to a lattice point.
double lattice(int x, int y, int z, int period) {
  if (period > 0) { x = ((x % period) + period) % period; y = ((y % period) + period) % period; }
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343u ^ static_cast<std::uint32_t>(y) * 0xd8163841u ^
                    static_cast<std::uint32_t>(z) * 0xcb1ab31fu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;         // finaliser of MurmurHash3 kind: neighbours become unrelated
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return static_cast<double>((h ^ (h >> 15)) & 0xffffffu) / 16777215.0;
}

double blend(double a, double b, double t) { return a + (b - a) * t; }                 // all [1]
double ease(double t) { return t * t * (3.0 - 2.0 * t); }                              // all [1]

int floorOf(double x) {                                                                // [1]
  const int i = static_cast<int>(x);
  return x < i ? i - 1 : i;
}

/// The field on the edge of a lattice cell that stands at x = i.
double edge(int i, double y, double z, int period) {                                   // all [1]
  const int j = floorOf(y), k = floorOf(z);
  const double v = ease(y - j), w = ease(z - k);                                       // [1]
  return blend(blend(lattice(i, j, k, period), lattice(i, j + 1, k, period), v),
               blend(lattice(i, j, k + 1, period), lattice(i, j + 1, k + 1, period), v), w);
}

/// Each octave half as strong as the one before; `octave` takes its number and its scale.
template <typename Octave>
double sumOf(int octaves, Octave octave) {
  double sum = 0.0, total = 0.0, strength = 1.0;                                       // [1]
  for (int o = 0; o < octaves; ++o) {
    sum += strength * octave(o, static_cast<double>(1 << o));
    total += strength;
    strength *= 0.5;
  }
  return sum / total;
}

}  // namespace

double noise(double x, double y, double z) {
  const int i = floorOf(x);
  return blend(edge(i, y, z, 0), edge(i + 1, y, z, 0), ease(x - i));
}

double fractalNoise(double x, double y, double z, int octaves) {
  return sumOf(octaves, [&](int o, double scale) { return noise(x * scale, y * scale, z * scale + 17.0 * o); });   // [1]
}

double NoiseWalk::octave(Cell& cell, double x, double y, double z, int period) const {
  const int i = floorOf(x);
  const bool sameRow = cell.known && cell.y == y && cell.z == z;
  if (!sameRow || cell.i != i) {
    cell.near = sameRow && i == cell.i + 1 ? cell.far : edge(i, y, z, period);
    cell.far = edge(i + 1, y, z, period);
    cell.i = i;
    cell.y = y;
    cell.z = z;
    cell.known = true;
  }
  return blend(cell.near, cell.far, ease(x - i));
}

double NoiseWalk::at(double x, double y, double z) {
  return sumOf(octaves_, [&](int o, double scale) {                                    // [1]
    return octave(cells_[o], x * scale, y * scale, z * scale + 17.0 * o, period_ << o);
  });
}

double nextRandom(std::uint32_t& seed) {
  seed = seed * 1664525u + 1013904223u;
  return (seed >> 8) / 16777216.0;
}

double smoothStep(double low, double high, double x) { return ease(std::clamp((x - low) / (high - low), 0.0, 1.0)); }

}  // namespace halsted::render
