#pragma once
/// A body that can be needled: nested closed surfaces as harmonics, and the acupoints on its skin. Built by `scenes/`, or read back from
/// a recording; constant afterwards.
#include <string>
#include <vector>

#include "sim/needling/needling_params.h"

namespace halsted {

struct Acupoint {
  std::string id, name;                        // "ST36", "Zusanli"
  Vec3 unit = Vec3::UnitZ();                   // where on the sphere that the skin is mapped from
  double depth = 20e-3;                        // [m] textbook depth of the tip, along the needle
  double angle = 1.5707963267948966;           // [rad] textbook angle between needle and skin
  Vec3 lean = Vec3::UnitX();                   // [1] along the skin, the way an oblique needle points
};

struct Body {
  int order = 0;                               // of the harmonics; 0: there is no body
  std::array<std::vector<Vec3>, kLayers> surface;   // [m] coefficients of the tops of skin, fat, muscle
  std::array<double, kLayers> thickness{};     // [m] at the target
  std::vector<Acupoint> points;
  std::int32_t target = 0;                     // of `points`: the one that is to be needled

  bool empty() const { return order == 0; }
};

}  // namespace halsted
