#include "render/instruments.h"

#include "render/blade.h"
#include "render/excision_tools.h"

#include <algorithm>
#include <cmath>

namespace halsted::render {
namespace {

/// Mayo-Hegar pattern: short serrated jaws, box lock, shanks that cross at the pin, ring handles.
Shape needleDriverHalf(double side) {                       // [1] +1 or -1: the side of the jaw
  Shape shape;
  addBlade(shape, {{0.0, 0.02e-3, 0.95e-3, 2.0e-3}, {0.5e-3, 0.02e-3, 1.25e-3, 2.3e-3}, {6e-3, 0.02e-3, 1.7e-3, 2.9e-3},
                   {10.5e-3, 0.02e-3, 2.5e-3, 3.9e-3}, {12e-3, -0.6e-3, 3.0e-3, 5.0e-3}},
           {0.2e-3, 9.6e-3, 0.5e-3, 0.16e-3}, side);
  // The two halves of the box lock lie one over the other along y.
  addBlade(shape, {{11e-3, -2.6e-3, 3.0e-3, 4.4e-3}, {13e-3, -3.3e-3, 3.3e-3, side > 0 ? 5.6e-3 : 4.4e-3},
                   {20e-3, -3.3e-3, 3.3e-3, side > 0 ? 5.6e-3 : 4.4e-3}, {23e-3, -2.8e-3, 1.0e-3, 4.0e-3}}, {}, side);
  addBlade(shape, {{22e-3, -2.9e-3, 0.6e-3, 4.0e-3}, {34e-3, -3.7e-3, -0.5e-3, 3.4e-3}, {70e-3, -5.2e-3, -2.0e-3, 3.4e-3},
                   {118e-3, -10e-3, -6.8e-3, 3.6e-3}, {128e-3, -13e-3, -9.5e-3, 3.6e-3}}, {}, side);
  addRing(shape, 11e-3, 1.9e-3, {Vec3(-side * 20.5e-3, 0.0, 136e-3), Quat::Identity()}, kGold);
  Pose pin{Vec3(0.0, side * 2.7e-3, 16e-3), Quat(Eigen::AngleAxisd(-side * 90 * kDegree, Vec3::UnitX()))};
  addRevolved(shape, {{2.1e-3, -0.4e-3}, {2.1e-3, 0.25e-3}, {1.5e-3, 0.45e-3}}, pin, kSteel);
  return shape;
}

/// Thumb forceps: one long tapered blade with a ribbed thumb rest, sprung at the far end.
Shape forcepsHalf(double side) {                            // [1]
  Shape shape;
  addBlade(shape, {{0.0, 0.0, 0.55e-3, 1.1e-3}, {0.6e-3, 0.0, 0.8e-3, 1.5e-3}, {14e-3, 0.12e-3, 1.15e-3, 2.1e-3},
                   {30e-3, 0.9e-3, 2.1e-3, 3.6e-3}, {58e-3, 3.2e-3, 4.6e-3, 7.6e-3}, {88e-3, 3.0e-3, 4.4e-3, 8.6e-3},
                   {112e-3, 0.6e-3, 1.9e-3, 7.0e-3}, {122e-3, 0.0, 1.3e-3, 6.2e-3}},
           {0.2e-3, 11e-3, 0.6e-3, 0.10e-3}, side);
  for (int rib = 0; rib < 9; ++rib) {                       // thumb rest
    const double z = (52.0 + 2.2 * rib) * 1e-3;             // [m]
    addBlade(shape, {{z, 3.9e-3, 4.75e-3, 6.6e-3}, {z + 1.1e-3, 3.9e-3, 4.85e-3, 6.8e-3}}, {}, side);
  }
  return shape;
}

/// The patterns above are drawn for jaws of this size.
constexpr JawShape kDrawn{12e-3, 1.2e-3, 25.0 * kDegree};

/// Stretches the jaws to the wanted size; what lies behind them moves along unchanged.
void fitJaws(const JawShape& jaws, Shape& half) {
  const double longer = jaws.length - kDrawn.length, stretch = jaws.length / kDrawn.length;   // [m], [1]
  for (ShapeVertex& v : half.vertices) {
    const double z = v.position[2], behind = std::clamp(z / kDrawn.length, 0.0, 1.0);         // [m], [1]
    const double thicker = jaws.radius / kDrawn.radius * (1.0 - behind) + behind;             // [1]
    v.position[0] = static_cast<float>(v.position[0] * thicker);
    v.position[1] = static_cast<float>(v.position[1] * thicker);
    v.position[2] = static_cast<float>(z < kDrawn.length ? z * stretch : z + longer);
  }
}

/// How an instrument is drawn, and where it turns.
struct Pattern {
  Shape (*half)(double side) = nullptr;        // side [1]
  double hinge = 0.0;                          // [m] from the tips
};

const Pattern& patternOf(ToolKind kind) {
  static const Pattern driver{needleDriverHalf, 16e-3}, forceps{forcepsHalf, 118e-3}, allis{allisHalf, kAllisPin};
  return kind == ToolKind::kNeedleDriver ? driver : kind == ToolKind::kAllis ? allis : forceps;
}

}  // namespace

Instrument makeInstrument(ToolKind kind, const JawShape& jaws) {
  Instrument out;
  if (kind == ToolKind::kElectrocautery) {     // one piece: closing it is pressing its button
    out.halves[0] = cauteryPen(jaws.length);
    return out;
  }
  const Pattern& pattern = patternOf(kind);
  for (int h = 0; h < 2; ++h) out.halves[h] = pattern.half(h ? -1.0 : 1.0);
  for (Shape& half : out.halves) fitJaws(jaws, half);
  // Real hinges lie farther back than the simulated ones: the turn is what puts the tips equally far apart.
  out.hinge = pattern.hinge + jaws.length - kDrawn.length;
  out.openAngle = std::asin(std::clamp(jaws.length * std::sin(0.5 * jaws.openAngle) / out.hinge, 0.0, 1.0));
  return out;
}

std::vector<Vec3> shadowTriangles(const Shape& half) {
  constexpr double kFull = 1.15, kThins = 85e-3, kEnd = 0.1;   // [1], [m], [m] as kInstrumentDepthVertex has them
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i + 2 < half.indices.size(); i += 3) {
    Vec3 p[3];                                              // [m]
    double core[3] = {};                                    // [1] share of its width
    for (int k = 0; k < 3; ++k) {
      const float* at = half.vertices[half.indices[i + k]].position;   // [m]
      core[k] = std::clamp(kFull - at[2] / kThins, 0.0, 1.0);
      p[k] = Vec3(core[k] * at[0], core[k] * at[1], std::min<double>(at[2], kEnd));
    }
    if (core[0] + core[1] + core[2] > 0.0) corners.insert(corners.end(), p, p + 3);
  }
  return corners;
}

Pose halfPose(const Instrument& instrument, int half, double jaw, const Pose& tool) {
  const double turn = std::clamp(jaw, 0.0, 1.0) * instrument.openAngle * (half ? 1.0 : -1.0);   // [rad]
  const Quat q(Eigen::AngleAxisd(turn, Vec3::UnitY()));
  const Vec3 axis(0.0, 0.0, instrument.hinge);
  return {tool.apply(axis - q * axis), tool.orientation * q};
}

void addRod(Shape& shape, const CapsuleShape& rod) {
  const Vec3 along = rod.b - rod.a;                         // [m]
  const double length = along.norm(), r = rod.radius;      // [m]
  const Pose pose{rod.a, turnOnto(Vec3::UnitZ(), length > 0.0 ? along : Vec3(Vec3::UnitZ()))};
  std::vector<std::array<double, 2>> profile{{0.05 * r, -r}, {0.7 * r, -0.7 * r}, {r, 0.0}};   // [m]
  for (double from : {length - 3.4 * r, length - 1.5 * r}) {   // [m] two grooves that a stapler's clip snaps into
    if (from < 0.5 * r) continue;
    profile.insert(profile.end(), {{r, from}, {0.8 * r, from + 0.12 * r}, {0.8 * r, from + 0.5 * r}, {r, from + 0.62 * r}});
  }
  profile.insert(profile.end(), {{r, length - 0.1 * r}, {0.93 * r, length + 0.35 * r}, {0.7 * r, length + 0.7 * r},
                                 {0.38 * r, length + 0.92 * r}, {0.04 * r, length + r}});
  addRevolved(shape, profile, pose, {0.72, 0.74, 0.77});
}

}  // namespace halsted::render
