#pragma once
/// A material point of the tissue, as holes and stitches keep it. Physics thread; no heap.
#include <array>
#include <cstdint>
#include <span>

#include "sim/types.h"

namespace halsted {

struct Model;

struct TissuePoint {
  std::int32_t tet = -1;
  std::array<double, 4> weight{};              // [1] barycentric
  bool operator==(const TissuePoint&) const = default;
};

Vec3 pointOf(const Model&, const TissuePoint&, std::span<const Vec3> tissue);   // [m]

/// How far a newton at one point moves the other within a step.  [m/N]
double complianceBetween(const Model&, const TissuePoint&, const TissuePoint&);

/// How deep in its wall: 0 on the serosa, 1 on the mucosa.  [1]
double wallShare(const Model&, const TissuePoint&);

}  // namespace halsted
