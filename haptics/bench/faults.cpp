/// 10: what reaches the motors when something is wrong, and how long they may be asked for more than they can hold.
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/bench/bench.h"
#include "haptics/bench/driven.h"

namespace halsted::haptics::bench {

namespace {

constexpr double kZeroBy = 0.1;                // [s] devices.md: the fade of a model that grows old is over
constexpr double kContinuous = 0.88, kPeak = 3.3;   // [N] of the Touch

/// A normal grip that has pressed a wall of 800 N/m by 2 mm for a second.
Rig pressed(SpringWall& wall) {
  Rig rig(TouchDynamics{}, threeHands()[1].dynamics);
  rig.target.pose.position.y() = -2e-3;
  for (int i = 0; i < 1000; ++i) rig.advance(wall);
  rig.largestStep = rig.peak = 0.0;
  return rig;
}

Measurement milliseconds(const char* what, const std::string& condition, double value, double limit) {   // [ms]
  return {what, condition, value, "ms", Bound::kAtMost, limit};
}

/// Physics gives nothing for a while: the largest step of force in the stall and in the second after it.
void addPhysicsStall(int ticks, Measurements& all) {
  SpringWall wall{800.0, 0.5, 2e-3};
  Rig rig = pressed(wall);
  double zeroAfter = 0.0;                      // [ms] last tick of the stall with a force
  for (int i = 1; i <= ticks; ++i) {
    rig.tickOnly();
    if (rig.output.force.norm() > 0.0) zeroAfter = i;
  }
  for (int i = 0; i < 1000; ++i) rig.advance(wall);
  const std::string condition = "physics stalled for " + std::to_string(ticks) + " ms";
  all.push_back({"largest step of force in a tick", condition, rig.largestStep, "N", Bound::kAtMost, 0.15});
  all.push_back({"largest force", condition, rig.peak, "N", Bound::kAtMost, kPeak});
  if (ticks > 1e3 * kZeroBy) all.push_back(milliseconds("force is zero after", condition, zeroAfter, 1e3 * kZeroBy));
}

/// The haptic thread itself is late: the tick index jumps.
void addTickStall(int ticks, Measurements& all) {
  SpringWall wall{800.0, 0.5, 2e-3};
  Rig rig = pressed(wall);
  rig.index += static_cast<std::uint64_t>(ticks);
  for (int i = 0; i < 1000; ++i) rig.advance(wall);
  const std::string condition = "haptic thread stalled for " + std::to_string(ticks) + " ms";
  all.push_back({"largest force", condition, rig.peak, "N", Bound::kAtMost, kPeak});
  all.push_back({"force a second later", condition, rig.output.force.norm(), "N", Bound::kAtLeast, 0.5});
}

template <typename Spoil>
void addCut(const char* condition, Spoil&& spoil, Measurements& all) {
  SpringWall wall{800.0, 0.5, 2e-3};
  Rig rig = pressed(wall);
  spoil(rig);
  int ticks = 0;                               // with a force, from the one that sees the fault on
  for (rig.tickOnly(); ticks < 1000 && !(rig.output.force.norm() == 0.0); rig.tickOnly()) ++ticks;
  all.push_back(milliseconds("ticks until the force is zero", condition, ticks, 0.0));
  all.back().unit = "ticks";
}

/// NaN from the device itself.
void addBadReading(Measurements& all) {
  SpringWall wall{800.0, 0.5, 2e-3};
  DrivenRig rig;
  for (int i = 0; i < 1000; ++i) rig.advanceAt(Vec3(0.0, -2e-3, 0.0), wall);
  const double force = rig.tickAt(Vec3(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0)).norm();   // [N]
  all.push_back({"force in the tick of the fault", "the driver reads NaN", force, "N", Bound::kAtMost, 0.0});
}

}  // namespace

Measurements measureFaults() {
  Measurements all;
  for (const int stall : {5, 50, 500}) addPhysicsStall(stall, all);
  for (const int stall : {5, 50, 500}) addTickStall(stall, all);
  addCut("the model has a NaN", [](Rig& rig) { rig.contact.force.y() = std::nan(""), rig.contact.step = ++rig.steps; }, all);
  addCut("the device is unplugged", [](Rig& rig) { rig.device.setConnected(false); }, all);
  addBadReading(all);
  return all;
}

Measurements measureThermal() {
  DrivenRig rig;                               // a hand that leans on a wall with more than the peak
  SpringWall wall{1020.0, 0.0, 2e-3};
  double atPeak = 0.0, derated = 0.0, force = 0.0;   // [s] [s] [N]
  for (int i = 1; i <= 300000; ++i) {
    force = rig.advanceAt(Vec3(0.0, -4e-3, 0.0), wall).norm();
    if (force > 0.999 * kPeak) atPeak = 1e-3 * i;
    if (force > 1.05 * kContinuous) derated = 1e-3 * i;
  }
  const double heat = rig.state.limits.heat;   // [1]
  for (int i = 0; i < 60000; ++i) rig.advanceAt(Vec3(0.0, 10e-3, 0.0), wall);
  const double timeConstant = -60.0 / std::log(rig.state.limits.heat / heat);   // [s]
  return {{"peak force lasts, from cold", "3.3 N asked for", atPeak, "s", Bound::kAtLeast, 2.0},
          {"within 5 % of the continuous force after", "3.3 N asked for", derated, "s", Bound::kAtMost, 180.0},
          {"force after five minutes", "3.3 N asked for", force, "N", Bound::kAtMost, 1.02 * kContinuous},
          {"heat after five minutes", "1 is what 0.88 N keeps up for ever", heat, "1", Bound::kAtMost, 1.0},
          {"time constant of the motors' heat", "cooling", timeConstant, "s"}};
}

}  // namespace halsted::haptics::bench
