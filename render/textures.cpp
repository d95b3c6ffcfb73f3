#include "render/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/color.h"
#include "render/light.h"
#include "render/noise.h"
#include "sim/types.h"

namespace halsted::render {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;   // [rad]

struct Field {                                // one channel, tiling
  int size = 0;
  std::vector<double> value;                  // [1]
  double& at(int x, int y) { return value[((y % size + size) % size) * size + (x % size + size) % size]; }
};

void stamp(Field& field, double x, double y, double width) {       // pixels
  const int reach = static_cast<int>(std::ceil(width)) + 1;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const double px = std::floor(x) + dx, py = std::floor(y) + dy;                  // pixels
      const double d = std::hypot(px - x, py - y);                                    // pixels
      double& v = field.at(static_cast<int>(px), static_cast<int>(py));
      v = std::max(v, smoothStep(width + 0.9, width - 0.6, d) * std::min(1.0, 0.45 + 0.45 * width));
    }
}

struct Vessel { double x, y, heading, width; int depth; };          // pixels, pixels, [rad], pixels

/// A vessel wanders, thins out and sends branches to both sides, as the vasa recta do on the colon.
void grow(Field& field, Vessel v, std::uint32_t& seed) {
  const auto chance = [&] { return nextRandom(seed); };                                // [1]
  const int steps = static_cast<int>((v.depth == 0 ? 0.85 : 0.30 / v.depth) * field.size * (0.6 + 0.8 * chance()));
  for (int s = 0; s < steps; ++s) {
    stamp(field, v.x, v.y, v.width);
    v.heading += 0.24 * (chance() - 0.5);
    v.x += std::cos(v.heading);
    v.y += std::sin(v.heading);
    v.width = std::max(0.35, v.width * 0.9975);
    if (v.depth < 3 && chance() < 0.024)
      grow(field, {v.x, v.y, v.heading + (chance() < 0.5 ? -1 : 1) * (0.5 + 0.6 * chance()), 0.68 * v.width, v.depth + 1}, seed);
  }
}

Field makeVessels(int size) {
  Field field{size, std::vector<double>(static_cast<std::size_t>(size) * size, 0.0)};
  std::uint32_t seed = 20;
  for (int k = 0; k < 7; ++k)
    grow(field, {0.13 * size * k, (0.143 * k + 0.07) * size, (k % 2 ? 0.5 : 0.0) * kTurn + 0.2, 2.6 - 0.2 * k, 0}, seed);
  return field;
}

double bulge(double x) { return std::abs(std::sin(0.5 * kTurn * x)); }                 // [1]

/// Ceiling, lamp with its ring of bulbs, bright walls, the dark band of gowns around the table, drapes below.
Vec3 theatre(const Vec3& d) {                                                          // unit direction; linear light [1]
  const double up = d.z();                                                             // [1] toward the surgeon and the lamp
  Vec3 light = mixed(Vec3(0.22, 0.27, 0.28), Vec3(0.05, 0.06, 0.065), smoothStep(-0.5, 0.05, up));
  light += smoothStep(-0.05, 0.30, up) * smoothStep(0.75, 0.40, up) * Vec3(0.58, 0.61, 0.66);         // bright walls
  light += smoothStep(0.55, 0.70, up) * smoothStep(0.86, 0.76, up) * Vec3(0.20, 0.22, 0.23);         // gowns and masks
  light += smoothStep(0.80, 0.96, up) * Vec3(0.48, 0.49, 0.51);                                       // ceiling
  light += smoothStep(0.90, 0.95, 0.75 * d.x() - 0.25 * d.y() + 0.60 * up) * Vec3(0.9, 0.93, 1.0);    // two light panels
  light += smoothStep(0.91, 0.95, -0.82 * d.x() + 0.15 * d.y() + 0.55 * up) * Vec3(0.8, 0.83, 0.9);
  const Vec3 lamp = lightDirection();
  const Vec3 side = lamp.cross(Vec3::UnitX()).normalized(), other = lamp.cross(side);
  double bulbs = 1.5 * smoothStep(0.955, 0.975, d.dot(lamp));                          // [1]
  for (int k = 0; k < 6; ++k) {
    const double a = kTurn * k / 6.0;                                                  // [rad]
    const Vec3 at = (lamp + 0.2 * (std::cos(a) * side + std::sin(a) * other)).normalized();
    bulbs += 2.6 * smoothStep(0.9935, 0.9975, d.dot(at));
  }
  return light + std::min(bulbs, 3.6) * Vec3(1.0, 0.97, 0.92);
}

}  // namespace

Image makeTissueImage(int size) {
  Field vessels = makeVessels(size);
  NoiseWalk mottles(5, 8), grains(3, 24), folds(3, 8), films(3, 16);
  return bake(size, [&](int x, int y) -> std::array<double, 4> {
    const double u = 8.0 * x / size, v = 8.0 * y / size;                               // [1]
    const double mottle = mottles.at(u, v, 0.0);                               // [1]
    const double cells = grains.at(3 * u, 3 * v, 9.0);                       // [1]
    const double fold = bulge(folds.at(u, v, 4.0) * 3.0);                    // [1]
    const double bump = 0.45 * cells + 0.35 * fold + 0.2 * vessels.at(x, y);           // [1]
    return {smoothStep(0.25, 0.75, mottle), vessels.at(x, y), bump, films.at(2 * u, 2 * v, 2.0)};
  });
}

Image makeReflectionImage(int size) {
  return bake(size, [&](int x, int y) -> std::array<double, 4> {
    const double u = 2.0 * (x + 0.5) / size - 1.0, v = 2.0 * (y + 0.5) / size - 1.0;       // [1] sphere map: n = (u, v, n_z)
    const double r2 = std::min(u * u + v * v, 0.999);                                      // [1]
    const double nz = std::sqrt(1.0 - r2);                                                 // [1]
    const Vec3 seen = theatre(Vec3(2.0 * nz * u, 2.0 * nz * v, 2.0 * nz * nz - 1.0));
    const auto encode = [](double c) { return std::sqrt(0.25 * std::min(c, 4.0)); };       // [1]
    return {encode(seen.x()), encode(seen.y()), encode(seen.z()), 1.0};
  });
}

}  // namespace halsted::render
