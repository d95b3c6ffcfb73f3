#include "render/excision_tools.h"

#include <algorithm>
#include <cmath>

#include "render/blade.h"

namespace halsted::render {
namespace {

constexpr Color kSleeve{0.055, 0.06, 0.075};     // insulation over the electrode
constexpr Color kHandle{0.10, 0.17, 0.34};       // plastic of the pen
constexpr Color kCutButton{0.80, 0.58, 0.05};    // yellow: cut
constexpr Color kCoagButton{0.05, 0.22, 0.62};   // blue: coagulation
constexpr Color kSoot{0.06, 0.05, 0.045};

/// A flat box with rounded ends, `half` of its length to either side along z.
struct Button { double z = 0.0, half = 0.0, width = 0.0, top = 0.0; };   // [m] all; top: height over the axis

void addButton(Shape& shape, const Button& b, const Color& color) {
  constexpr int kRings = 5, kSides = 8;
  Loft loft{kRings, kSides, {}, [&](int, int) { return color; }};
  loft.point = [&](int i, int k) {
    static constexpr double kAt[kRings] = {-1.0, -0.85, 0.0, 0.85, 1.0}, kFull[kRings] = {0.6, 1.0, 1.0, 1.0, 0.6};   // [1]
    const double a = 2.0 * std::numbers::pi * k / kSides;                          // [rad]
    const double lift = b.top - 0.6e-3 * (1.0 - kFull[i]);                         // [m]
    return Vec3(0.5 * b.width * kFull[i] * std::cos(a), lift + 0.9e-3 * std::sin(a), b.z + b.half * kAt[i]);
  };
  addLoft(shape, loft);
}

/// A spatula: flat along x, as broad as a real one is, sooty where it has burnt.
void addSpatula(Shape& shape, double length) {   // [m]
  constexpr int kRings = 9, kSides = 10;
  Loft loft{kRings, kSides, {}, {}};
  const auto at = [&](int i) { return length * 1.08 * i / (kRings - 1); };         // [m]
  loft.point = [&](int i, int k) {
    const double z = at(i), round = std::sqrt(std::clamp(z / 1.1e-3, 0.0, 1.0));    // [m] [1]
    const double a = 2.0 * std::numbers::pi * k / kSides;                          // [rad]
    const double neck = std::clamp((z - 0.75 * length) / (0.25 * length), 0.0, 1.0);   // [1] flat blade, round stem
    const double broad = (1.0 - neck) * 1.15e-3 * (0.12 + 0.88 * round) + neck * 0.75e-3;   // [m]
    const double thick = (1.0 - neck) * 0.32e-3 * (0.4 + 0.6 * round) + neck * 0.75e-3;     // [m]
    return Vec3(thick * std::cos(a), broad * std::sin(a), z);
  };
  loft.color = [&](int i, int) {
    const double clean = std::clamp((at(i) - 1.5e-3) / 5e-3, 0.0, 1.0);             // [1]
    Color c{};
    for (int k = 0; k < 3; ++k) c[k] = kSoot[k] + clean * (kSteel[k] - kSoot[k]);
    return c;
  };
  addLoft(shape, loft);
}

}  // namespace

Shape allisHalf(double side) {
  Shape shape;
  // Teeth: broad across y, meeting in the middle; behind them the jaws stand apart, so that tissue is held by its edge only.
  addBlade(shape, {{0.0, 0.0, 1.1e-3, 5.6e-3}, {1.4e-3, 0.05e-3, 1.9e-3, 5.4e-3}, {3.2e-3, 1.3e-3, 2.9e-3, 3.6e-3},
                   {12e-3, 2.0e-3, 3.7e-3, 2.9e-3}, {24e-3, 1.4e-3, 3.6e-3, 3.6e-3}, {29e-3, -0.4e-3, 3.2e-3, 4.6e-3}},
           {0.1e-3, 1.5e-3, 0.5e-3, 0.25e-3}, side);
  addBlade(shape, {{28e-3, -2.4e-3, 3.0e-3, 4.2e-3}, {31e-3, -3.1e-3, 3.1e-3, side > 0 ? 5.4e-3 : 4.3e-3},
                   {37e-3, -3.1e-3, 3.1e-3, side > 0 ? 5.4e-3 : 4.3e-3}, {40e-3, -2.6e-3, 0.9e-3, 3.8e-3}}, {}, side);   // box lock
  addBlade(shape, {{39e-3, -2.7e-3, 0.6e-3, 3.8e-3}, {52e-3, -3.6e-3, -0.7e-3, 3.1e-3}, {92e-3, -5.4e-3, -2.4e-3, 3.1e-3},
                   {138e-3, -10.5e-3, -7.6e-3, 3.3e-3}, {149e-3, -13.5e-3, -10.2e-3, 3.4e-3}}, {}, side);
  addBlade(shape, {{126e-3, -8.6e-3, 1.2e-3, 2.2e-3}, {129e-3, -8.8e-3, 1.4e-3, 2.2e-3}}, {}, side);                  // ratchet arm
  addRing(shape, 10.5e-3, 1.8e-3, {Vec3(-side * 20.5e-3, 0.0, 157e-3), Quat::Identity()}, kSteel);
  const Pose pin{Vec3(0.0, side * 2.6e-3, kAllisPin), Quat(Eigen::AngleAxisd(-side * 90 * kDegree, Vec3::UnitX()))};
  addRevolved(shape, {{1.9e-3, -0.4e-3}, {1.9e-3, 0.25e-3}, {1.3e-3, 0.45e-3}}, pin, kSteel);
  return shape;
}

Shape cauteryPen(double blade) {
  Shape shape;
  const double s = blade;                        // [m] where the sleeve begins
  addSpatula(shape, blade);
  addRevolved(shape, {{0.8e-3, s}, {1.5e-3, s + 0.3e-3}, {1.6e-3, s + 12e-3}, {2.2e-3, s + 13e-3}}, Pose{}, kSleeve);
  addRevolved(shape, {{2.0e-3, s + 12.6e-3}, {2.9e-3, s + 15e-3}, {4.4e-3, s + 30e-3}, {5.0e-3, s + 48e-3}, {5.2e-3, s + 90e-3},
                      {4.6e-3, s + 128e-3}, {2.4e-3, s + 134e-3}}, Pose{}, kHandle);
  addRevolved(shape, {{1.9e-3, s + 133e-3}, {1.7e-3, s + 170e-3}}, Pose{}, kSleeve);
  addButton(shape, {s + 38e-3, 4.2e-3, 4.6e-3, 4.7e-3}, kCutButton);
  addButton(shape, {s + 50e-3, 4.2e-3, 4.6e-3, 5.1e-3}, kCoagButton);
  return shape;
}

}  // namespace halsted::render
