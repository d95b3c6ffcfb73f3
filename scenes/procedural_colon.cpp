#include "scenes/procedural_colon.h"

#include <array>
#include <cmath>

#include "scenes/tube_grid.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

constexpr double kHaustraPitch = 24e-3;                          // [m] fold to fold; tuned: reads as sigmoid colon
constexpr double kRoundRim = 14e-3;                              // [m] the haustra fade over this length; tuned
constexpr std::array<double, 3> kRowShift = {0.0, 0.37, 0.71};   // [1] the three rows of sacs are staggered
constexpr double kFoldShare = 0.5;                               // [1] folds reach in by this share of what sacs reach out; tuned

/// Three taeniae at 90, 210 and 330 degrees; between them a row of sacs. The bulge and its slope vanish at a taenia, so the rows may
/// be staggered and the surface still has continuous normals.
double outerRadius(const AnatomyParams& params, double angle, double depth) {  // angle [rad], depth [m]
  const double fromTaenia = angle - 0.5 * kPi + 2.0 * kPi;                     // [rad] positive
  const int row = static_cast<int>(std::floor(fromTaenia * 3.0 / (2.0 * kPi))) % 3;
  const double bulge = 0.5 * (1.0 - cosine(3.0 * fromTaenia));                 // [1]
  const double wave = 0.5 * (1.0 - cosine(2.0 * kPi * (depth / kHaustraPitch + kRowShift[row])));  // [1]
  const double sac = wave * (2.0 - wave);                                      // [1] wide sacs, narrow folds
  const double shape = bulge * ((1.0 + kFoldShare) * sac - kFoldShare);        // [1]
  return params.radius + params.haustraDepth * smoothStep(depth / kRoundRim) * shape;
}

}  // namespace

TetMesh proceduralColon(const AnatomyParams& params) {
  TubeGrid grid;
  grid.around = params.around;
  grid.along = params.along;
  for (int row = 0; row < grid.along; ++row) {
    const double depth = params.length * row / (grid.along - 1);               // [m]
    grid.depth.push_back(depth);
    grid.axis.emplace_back(0.0, 0.0, -depth);
    for (int column = 0; column < grid.around; ++column) {
      const double angle = 2.0 * kPi * column / grid.around;                   // [rad]
      const double radius = outerRadius(params, angle, depth);                 // [m]
      grid.outer.emplace_back(radius * cosine(angle), radius * sine(angle), -depth);
    }
  }
  return wallMesh(grid, params.wall);
}

}  // namespace halsted::scenes
