#include "sim/tools/load_driver.h"

namespace halsted {
namespace {

/// The loaded needle driver: needle plane across the shaft, jaws opening along the needle's radius, held this far along the arc.
constexpr double kHoldShare = 0.35;            // [1] of the arc, from the swage

double holdCoordinate(const StrandModel& m) { return m.length + kHoldShare * (tipCoordinate(m) - m.length); }   // [m]

}  // namespace

bool beginsWithNeedle(const Model& m) { return m.params.tools[kRight].kind != ToolKind::kElectrocautery; }

bool threadOnTable(const Model& m, const State& s) { return !beginsWithNeedle(m) && !(s.supply && s.supply->handed > 0); }

Pose needleOnTable() { return {Vec3(0.0, -0.2, -0.6), Quat::Identity()}; }

Pose loadedNeedle(const StrandModel& m) {
  Vec3 point, tangent;
  arcAt(m, holdCoordinate(m), point, tangent);
  const Vec3 radial = point.normalized();
  Mat3 needleAxes;                             // columns: tool axes seen in the needle frame
  needleAxes.col(0) = radial;
  needleAxes.col(1) = tangent;
  needleAxes.col(2) = Vec3::UnitZ();
  Pose pose;
  pose.orientation = Quat(Mat3(needleAxes.transpose())).normalized();
  pose.position = -(pose.orientation * point);
  return pose;
}

Pose loadDriver(const Model& m, ToolState& driver) {
  driver.jaw = 0.0;
  driver.closed = driver.ratchet = driver.holdsNeedle = true;
  driver.needleCoordinate = holdCoordinate(m.strand);
  driver.needleInTool = loadedNeedle(m.strand);
  return compose(driver.proxy, driver.needleInTool);
}

}  // namespace halsted
