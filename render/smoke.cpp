#include "render/smoke.h"

#include <cmath>
#include <numbers>

#include "render/discs.h"
#include "render/noise.h"

namespace halsted::render {
namespace {

constexpr double kLife = 1.2;                // [s] of a puff
constexpr double kRise = 32e-3;              // [m] in that time; a theatre's air carries it off soon
constexpr double kDrift = 7e-3;              // [m] sideways, at most
constexpr double kNewRadius = 0.7e-3, kOldRadius = 7e-3;   // [m]
constexpr double kDense = 0.50;              // [1] of a young puff

}  // namespace

std::array<Puff, kPuffs> plumeOver(const Vec3& electrode, const Vec3& up, double time) {   // [m], [1], [s]
  std::array<Puff, kPuffs> plume;
  const Vec3 side = up.unitOrthogonal(), across = up.cross(side);
  for (int k = 0; k < kPuffs; ++k) {
    const double turns = time / kLife + static_cast<double>(k) / kPuffs, generation = std::floor(turns);   // [1]
    const double age = turns - generation;     // [1] of its life
    auto seed = static_cast<std::uint32_t>(generation) * kPuffs + static_cast<std::uint32_t>(k) + 1u;
    nextRandom(seed);
    const double way = 2.0 * std::numbers::pi * nextRandom(seed) + 2.0 * age, reach = kDrift * age * nextRandom(seed);   // [rad], [m]
    plume[k].centre = electrode + reach * (std::cos(way) * side + std::sin(way) * across) + kRise * age * (1.5 - 0.5 * age) * up;
    plume[k].radius = kNewRadius + (kOldRadius - kNewRadius) * std::sqrt(age);
    plume[k].strength = kDense * smoothStep(0.0, 0.2, age) * (1.0 - age) * (1.0 - age);
  }
  return plume;
}

void laySmoke(const RenderSnapshot& snapshot, const Vec3& up, const CameraView& camera, Discs& discs) {   // [1]
  discs.clear();
  for (const ToolView& tool : snapshot.tools) {
    if (!tool.smokes) continue;
    for (const Puff& puff : plumeOver(tool.pose.position, up, snapshot.time)) discs.add(facing(camera, puff.centre), puff.radius, puff.strength);
  }
}

}  // namespace halsted::render
