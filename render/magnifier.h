#pragma once
/// Where the magnified view of the needle's entry lies in the picture, for what draws it and for the words round it.
#include "sim/exchange.h"

namespace halsted::render {

constexpr double kGlassHeight = 5e-3;                    // [m] of skin that it shows
constexpr double kGlassReach = 8e-3;                     // [m] it opens when the tip is that near to the skin

struct Glass { int x, y, width, height; };               // pixels from the upper left corner

inline Glass magnifier(int width, int height) {          // of the picture, pixels
  const double s = height / 720.0;                       // [1]
  return {width - static_cast<int>(252 * s), static_cast<int>(88 * s), static_cast<int>(240 * s), static_cast<int>(200 * s)};
}
inline bool magnified(const RenderSnapshot& snapshot) { return snapshot.needling.depth > -kGlassReach; }

}  // namespace halsted::render
