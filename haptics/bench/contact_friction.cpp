/// 9: the friction of the contact is felt. A tool dragged over a slab shows Coulomb's cone in the force on the hand.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "haptics/bench/bench.h"
#include "haptics/bench/block.h"
#include "haptics/bench/driven.h"

namespace halsted::haptics::bench {

namespace {

constexpr double kDegree = 57.29577951308232;  // [deg] of a radian
constexpr double kPressed = 1e-3;              // [m]
constexpr double kStroke = 6e-3;               // [m] to and fro
constexpr double kSpeed = 20e-3;               // [m/s]

struct Dragged { double along = 0.0, normal = 0.0; };   // [N] mean, against the motion and away from the slab

/// To and fro, so that what a slope of the surface adds to one way it takes from the other.
Dragged drag(double friction) {                // [1]
  BlockShape shape;
  shape.friction = friction;
  const Model model = blockModel(shape);
  DrivenRig rig;
  BlockStep block(model, {above(0.0, 0.0, 1e-3), farAway()});
  const double dt = model.params.dt;           // [s]
  double x = 0.0, gap = 1e-3, way = 1.0;       // [m] [m] [1]
  for (; gap > -kPressed; gap -= kSpeed * dt) rig.advanceAt(above(x, 0.0, gap).position, block);
  Dragged sum;
  int counted = 0;
  for (int stroke = 0; stroke < 5; ++stroke, way = -way)
    for (int i = 0, n = static_cast<int>(kStroke / (kSpeed * dt)); i < n; ++i) {
      x += way * kSpeed * dt * (stroke == 0 ? 0.5 : 1.0);
      const Vec3 force = rig.advanceAt(above(x, 0.0, gap).position, block);   // [N]
      if (stroke == 0 || i < n / 2) continue;  // the turn is over: it slides
      sum.along -= way * force.x();
      sum.normal += force.z();
      ++counted;
    }
  return {sum.along / counted, sum.normal / counted};
}

}  // namespace

Measurements measureContactFriction() {
  Measurements all;
  for (const double friction : {0.1, 0.2, 0.4}) {
    const Dragged felt = drag(friction);
    char text[64];
    std::snprintf(text, sizeof text, "mu = %.1f, pressed with %.2f N, 20 mm/s", friction, felt.normal);
    const double angle = kDegree * std::atan2(felt.along, felt.normal), wanted = kDegree * std::atan(friction);   // [deg]
    all.push_back({"friction felt along the drag", text, felt.along, "N"});
    all.push_back({"error of the angle of the friction cone", text, std::abs(angle - wanted), "deg", Bound::kAtMost, 0.1 * wanted});
  }
  return all;
}

}  // namespace halsted::haptics::bench
