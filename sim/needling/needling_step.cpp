#include <algorithm>

#include "sim/needling/needling.h"
#include "sim/needling/needling_layers.h"

namespace halsted {
namespace {

constexpr double kCutBlend = 0.5e-3;           // [m] of shaft in a layer until the tip cuts with that layer's force (design)
constexpr double kContactDamping = 0.4;        // [N s/m] of the device while touching, as for every tool (sim/tools/local_contact.cpp)
constexpr double kSteepest = 0.1;              // [1] cosine: a needle that lies flatter on the skin does not go in

bool usable(const ToolSample& sample) {
  return sample.pose.position.allFinite() && sample.pose.orientation.coeffs().allFinite() && sample.velocity.allFinite();
}

Mat3 along(const Vec3& a) { return a * a.transpose(); }

/// Nothing touched: the plane of the skin says where touching would begin.
struct Onset { double gap = 0.0, pressed = 0.0, stiffness = 0.0; };   // [m] to the skin; skin below its rest; [N/m] that waits there
void feelNothing(const SurfaceFrame& foot, const Vec3& at, const Onset& onset, LocalContact& c) {
  constexpr double kNear = 5e-3;               // [m]
  c.position = at;
  c.force.setZero();
  c.stiffness = onset.stiffness * Mat3::Identity();
  c.damping.setZero();
  c.touching = false;
  c.ahead = onset.gap < kNear;
  c.planeCount = c.ahead ? 1 : 0;
  c.planes[0] = {foot.position - onset.pressed * foot.normal, foot.normal};
}

void beginContact(const NeedlingState& s, LocalContact& c) {
  c.step = s.step;
  c.puncture = false;
}

void stepFinger(const NeedlingModel& m, const ToolSample& sample, NeedlingState& s, LocalContact& out) {
  beginContact(s, out);
  const SurfaceFrame f = nearestPoint(m.surface[0], sample.pose.position, s.fingerUnit, 2);
  s.fingerUnit = f.unit;
  const double depth = -(sample.pose.position - f.position).dot(f.normal);   // [m]
  s.fingerDepth = std::max(0.0, depth);
  s.fingerPlace = f.position;
  s.fingerNormal = f.normal;
  feelNothing(f, sample.pose.position, {-depth, 0.0, m.params.fingerStiffness}, out);
  if (depth <= 0.0) return;
  out.touching = true;
  out.ahead = false;
  out.force = m.params.fingerStiffness * depth * f.normal;
  out.stiffness = m.params.fingerStiffness * along(f.normal);
  out.damping = kContactDamping * Mat3::Identity();
}

/// The skin at rest below the tip; a dimple begins when the tip is below it.
bool touchSkin(const NeedlingModel& m, const Vec3& tip, NeedlingState& s, LocalContact& out) {
  const SurfaceFrame f = nearestPoint(m.surface[0], tip, s.skinUnit, 2);
  s.skinUnit = f.unit;
  const double pressed = pressedDepth(m, s, f.position);     // [m]
  s.depth = -(tip - f.position).dot(f.normal) - pressed;
  s.contact = f.position;
  s.outward = f.normal;
  feelNothing(f, tip, {-s.depth, pressed, netStiffness(m.net[0], 0.0)}, out);
  if (!(s.depth > 0.0)) return false;
  s.axis = -f.normal;
  layNet(m, 0, f, s);
  return true;
}

/// The sharp tip drags the skin along until it slips; then the dimple is laid anew where the tip has come to.
Vec3 dragSkin(const NeedlingModel& m, const Vec3& offset, double press, NeedlingState& s) {   // [N], press [N]
  const double stiffness = netStiffness(m.net[0], s.depth), bound = m.params.surfaceGrip * press;   // [N/m], [N]
  Vec3 side = offset - offset.dot(s.outward) * s.outward;    // [m]
  const double length = side.norm();           // [m]
  if (stiffness * length > bound) {
    const Vec3 slip = side * (1.0 - bound / (stiffness * length));   // [m]
    const SurfaceFrame f = nearestPoint(m.surface[0], s.contact + slip, s.skinUnit, 2);
    side -= slip;
    s.skinUnit = f.unit;
    s.contact = f.position;
    s.outward = f.normal;
    s.axis = -f.normal;
    layNet(m, 0, f, s);
    pressNet(m, 0, s.depth, s);
  }
  return -stiffness * side;
}

/// From here on the needle keeps to its line.
void enterSkin(const NeedlingModel& m, const ToolSample& sample, double pressed, NeedlingState& s) {   // pressed [m]
  const Vec3 inward = -(sample.pose.orientation * Vec3::UnitZ());
  const double slant = -inward.dot(s.outward); // [1]
  s.axis = inward;
  s.depth = (s.depth + pressed) / slant;
  s.pressed = pressed / slant;
  s.entry = sample.pose.position - s.depth * inward;
  s.layers[0].phase = LayerPhase::kPunctured;
  s.layers[0].crossing = 0.0;
  s.friction = {};
  s.cut = {s.depth - s.pressed, 0.0};
  s.winding = {};
  s.needleTurn = sample.pose.orientation;
  findCrossings(m, s);
}

/// True when the skin gave way.
bool dimpleSkin(const NeedlingModel& m, const ToolSample& sample, NeedlingState& s, NeedlingOutput& out) {
  const Vec3 tip = sample.pose.position, offset = tip - s.contact;
  const double pressed = pressedDepth(m, s, s.contact);      // [m]
  s.depth = -offset.dot(s.outward) - pressed;
  if (!(s.depth > 0.0)) {
    s.layers[0].phase = LayerPhase::kFree;
    touchSkin(m, tip, s, out.needle);
    return false;
  }
  const bool steep = (sample.pose.orientation * Vec3::UnitZ()).dot(s.outward) > kSteepest;
  if (s.depth >= m.net[0].punctureDepth && steep) {
    out.lostSurfaceForce = pressNet(m, 0, s.depth, s);
    enterSkin(m, sample, pressed, s);
    out.punctured = 0;
    return true;
  }
  out.surfaceForce = pressNet(m, 0, s.depth, s);
  const double stiffness = netStiffness(m.net[0], s.depth);  // [N/m]
  const Vec3 side = dragSkin(m, offset, out.surfaceForce, s);
  out.needle.touching = true;
  out.needle.ahead = false;
  out.needle.planeCount = 0;
  out.needle.position = tip;
  out.needle.force = out.surfaceForce * s.outward + side;
  out.needle.stiffness = stiffness * Mat3::Identity();
  out.needle.damping = kContactDamping * Mat3::Identity();
  return false;
}

/// The next layer that is still whole: dimpled by the tip until it gives way.
void pressNextLayer(const NeedlingModel& m, NeedlingState& s, NeedlingOutput& out) {
  int k = 1;
  while (k < kLayers && s.layers[k].phase == LayerPhase::kPunctured) ++k;
  if (k == kLayers) return;
  LayerState& l = s.layers[k];
  const double z = s.depth - l.crossing - s.pressed;         // [m]
  l.phase = z > 0.0 ? LayerPhase::kDimpled : LayerPhase::kFree;
  if (!(z > 0.0)) return;
  const double force = pressNet(m, k, z, s);                 // [N]
  if (z < m.net[k].punctureDepth) { out.surfaceForce = force; return; }
  l.phase = LayerPhase::kPunctured;
  l.since = 0.0;
  out.punctured = k;
  out.lostSurfaceForce = force;
}

/// Rotation about the needle's axis since the last step, from the vector part of the difference: sin of half, by its series.
double turnAbout(const Vec3& axis, const Quat& before, const Quat& now) {   // [rad]
  const Quat change = now * before.conjugate();
  const double half = (change.w() < 0.0 ? -1.0 : 1.0) * change.vec().dot(axis);   // [1]
  return 2.0 * half * (1.0 + half * half / 6.0);
}

struct ShaftLoad { double friction = 0.0, damping = 0.0, cut = 0.0, length = 0.0; };   // [N], [N s/m], [N], [m]

ShaftLoad loadOf(const NeedlingModel& m, const NeedlingState& s, const std::array<double, kLayers>& inside) {   // inside [m]
  ShaftLoad load;
  for (int k = 0; k < kLayers; ++k) {
    const LayerParams& layer = m.params.layers[k];
    load.friction += s.winding.grasp * layer.friction * inside[k];
    load.damping += layer.damping * inside[k];   // physics.md A3 b: each layer by the shaft inside it
    load.cut += (layer.cutForce - load.cut) * std::min(1.0, inside[k] / kCutBlend);
    load.length += inside[k];
  }
  return load;
}

void writeShaftContact(const NeedlingModel& m, const ShaftLoad& load, const Vec3& side, NeedlingState& s, LocalContact& c) {
  const Mat3 axial = along(s.axis);
  // What the next millisecond of travel adds to the spring: all of it while the shaft holds, the share that the drag keeps while it slides.
  const double kept = s.friction.slid > 0.0 ? load.damping / (load.damping + m.params.shaftStiffness * m.params.dt) : 1.0;   // [1]
  double stiffness = load.length > 0.0 ? kept * m.params.shaftStiffness : 0.0;   // [N/m]
  if (s.cut.force > 0.0 && s.cut.force < 0.999 * load.cut) stiffness += m.params.tipStiffness;
  for (int k = 1; k < kLayers; ++k)
    if (s.layers[k].phase == LayerPhase::kDimpled) stiffness += netStiffness(m.net[k], dimple(s, k));
  const double sideways = m.params.sideStiffness * load.length;   // [N/m]
  c.touching = true;
  c.ahead = false;
  c.planeCount = 0;
  c.position = s.entry + s.depth * s.axis + side;
  c.stiffness = stiffness * axial + sideways * (Mat3::Identity() - axial);
  c.damping = kContactDamping * Mat3::Identity();
}

void withdraw(NeedlingState& s, NeedlingOutput& out) {
  for (LayerState& l : s.layers) { l.phase = LayerPhase::kFree; l.since = 0.0; }
  s.friction = {};
  s.cut = {};
  s.winding = {};
  s.pressed = 0.0;
  s.inside.fill(0.0);
  out.leftSkin = true;
}

void moveInside(const NeedlingModel& m, const ToolSample& sample, NeedlingState& s, NeedlingOutput& out) {
  const Vec3 offset = sample.pose.position - s.entry;
  const double depth = offset.dot(s.axis), pressed = pressedDepth(m, s, s.contact) / -s.axis.dot(s.layers[0].normal);   // [m]
  const double travel = depth - s.depth - (pressed - s.pressed);   // [m] past the tissue
  s.depth = depth;
  s.pressed = pressed;
  // What the shaft carries, each layer its share by friction.
  const std::array<double, kLayers> before = shaftInside(s);       // [m]
  const double whole = loadOf(m, s, before).friction;              // [N]
  for (int k = 0; k < kLayers; ++k) {
    const double share = whole > 0.0 ? s.winding.grasp * m.params.layers[k].friction * before[k] / whole : 0.0;   // [1]
    if (s.layers[k].phase == LayerPhase::kPunctured) releaseNet(m, k, share * s.friction.force, s);
  }
  pressNextLayer(m, s, out);
  out.inside = s.inside = shaftInside(s);
  const double turn = turnAbout(s.axis, s.needleTurn, sample.pose.orientation);   // [rad]
  s.needleTurn = sample.pose.orientation;
  const double lengthBefore = s.winding.length;                    // [m]
  const double length = out.inside[0] + out.inside[1] + out.inside[2];   // [m]
  windShaft(m.params, turn, length, s.winding);
  const ShaftLoad load = loadOf(m, s, out.inside);
  slideShaft(m.params, travel, {load.friction, load.damping}, s.friction);
  advanceTip(m.params, depth - pressed, load.cut, s.cut);
  // New length goes in where the needle is: it does not push sideways.
  Vec3 side = offset - depth * s.axis;         // [m]
  if (length > lengthBefore) {
    const Vec3 moved = side * (1.0 - lengthBefore / length);
    s.entry += moved;
    side -= moved;
  }
  out.frictionForce = s.friction.force - s.friction.drag;
  out.cutForce = s.cut.force;
  out.dampingForce = s.friction.drag;
  out.torque = s.winding.torque;
  writeShaftContact(m, load, side, s, out.needle);
  out.needle.force = -(out.surfaceForce + out.frictionForce + out.cutForce + out.dampingForce) * s.axis -
                     m.params.sideStiffness * length * side;
}

void stepNeedle(const NeedlingModel& m, const ToolSample& sample, NeedlingState& s, NeedlingOutput& out) {
  beginContact(s, out.needle);
  if (s.layers[0].phase == LayerPhase::kFree && !touchSkin(m, sample.pose.position, s, out.needle)) return;
  if (s.layers[0].phase == LayerPhase::kDimpled && !dimpleSkin(m, sample, s, out)) return;
  moveInside(m, sample, s, out);
  out.needle.puncture = out.punctured >= 0;
  if (s.depth <= std::min(s.pressed, dimple(s, 0))) {
    withdraw(s, out);
    touchSkin(m, sample.pose.position, s, out.needle);
    if (s.layers[0].phase == LayerPhase::kDimpled) s.layers[0].phase = LayerPhase::kFree;
  }
}

}  // namespace

void stepNeedling(const NeedlingModel& m, const NeedlingInput& in, NeedlingState& s, NeedlingOutput& out) {
  out.torque = out.surfaceForce = out.frictionForce = out.cutForce = out.dampingForce = out.lostSurfaceForce = 0.0;
  out.inside.fill(0.0);
  out.punctured = -1;
  out.leftSkin = false;
  if (usable(in.finger)) stepFinger(m, in.finger, s, out.finger);   // a sample that is not a number moves nothing
  if (usable(in.needle)) stepNeedle(m, in.needle, s, out);
  ++s.step;
}

}  // namespace halsted
