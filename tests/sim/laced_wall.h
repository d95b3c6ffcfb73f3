#pragma once
/// A stitch through the standing wall whose ends are already laced into a loose knot above it, each in the jaws of a tool: the whole step
/// tightens it.
#include <algorithm>

#include "tests/sim/knot_tie.h"
#include "tests/sim/tensile_test.h"
#include "tests/sim/threaded_wall.h"

namespace halsted {

struct LacedWall : ThreadedWall {
  explicit LacedWall(std::span<const int> halfTwists, double friction = ThreadContactParams{}.friction, int spare = 0)   // [1]; needled threads on the table
      : LacedWall(curveOf(halfTwists), friction, spare) {}

  /// Both hands draw their ends apart until they feel `newtons`, for so long; then they hold still.
  void drawTight(double newtons, double seconds) {   // [N], [s]
    constexpr double kSpeed = 0.05, kFeel = 0.5;     // [m/s], [N]
    for (int k = 0; k < seconds / model.params.dt; ++k) {
      for (int hand = 0; hand < kHands; ++hand) {
        const double lack = (newtons - state.tools[hand].threadForce.norm()) / kFeel;   // [1]
        input.tools[hand].pose.position += std::clamp(lack, -1.0, 1.0) * kSpeed * model.params.dt * way_[hand];
      }
      step();
    }
  }
  void letGo(double seconds) {                 // [s]
    for (ToolSample& t : input.tools) t.jaw = 1.0;
    run(static_cast<int>(seconds / model.params.dt));
  }
  /// Both hands up and aside, with nothing in their jaws.
  void goAside() {
    constexpr int kSteps = 300;
    for (int k = 0; k < kSteps; ++k) {
      for (int hand = 0; hand < kHands; ++hand) {
        const Vec3 to(hand == kLeft ? -0.06 : 0.06, 12e-3, 70e-3);   // [m]
        input.tools[hand].pose.position += (to - input.tools[hand].pose.position) / (kSteps - k);
      }
      step();
    }
  }
  /// As blades do, between the knot and the right hand.
  void cutOff() { state.threadContacts.cut[model.strand.nodes - 12] = 1; }
  /// Asks for a fresh thread, and steps.
  void ask() {
    input.command.kind = Command::Kind::kFreshThread;
    step();
    input.command = {};
  }
  /// Tension in the thread inside the wall.  [N]
  double stitchTension() const {
    const StrandState& s = state.strand;
    return strandTension(model.strand, s, 0.5 * (s.holes[0].coordinate + s.holes[s.holeCount - 1].coordinate), 1);
  }
  double seen(Quantity q) const { return out.seen[static_cast<int>(q)]; }   // unit of the quantity

 private:
  static constexpr double kSegment = 0.4e-3;   // [m]
  std::array<Vec3, kHands> way_;               // [1] in which each hand draws

  static std::vector<Vec3> curveOf(std::span<const int> halfTwists) {
    std::vector<Vec3> curve = LooseKnot(halfTwists, {}).nodes(kSegment);
    for (Vec3& p : curve) p = Vec3(2e-3 + p.x(), 12.1e-3 - p.z(), 23.2e-3 + p.y());   // its loop hangs down through the wall
    return curve;
  }
  static SimParams paramsFor(std::size_t nodes, double friction, int spare) {   // [1]
    SimParams p = wallParams();
    const SimParams thin = knotThread(kSegment);
    p.thread = thin.thread;
    p.needle = thin.needle;
    p.thread.nodes = static_cast<int>(nodes);
    p.thread.knots = true;
    p.thread.friction = friction;
    p.thread.spare = spare;
    p.thread.breakingTension = ThreadContactParams{}.breakingTension;
    p.needle.tearForce = 50.0;
    return p;
  }
  LacedWall(const std::vector<Vec3>& curve, double friction, int spare) : ThreadedWall(kNeedleAway, paramsFor(curve.size(), friction, spare)) {   // [1]
    state.strand.position = curve;
    state.strand.needle = KnotRig::needlePose(model.strand, curve);
    openHoles();
    take(kLeft, 4, curve[4] - curve[40]);
    take(kRight, model.strand.nodes - 5, curve[curve.size() - 5] - curve[curve.size() - 41]);
  }
  void take(int hand, int node, const Vec3& outward) {   // [m]
    ToolState& tool = state.tools[hand];
    tool.holdsNeedle = tool.ratchet = false;
    tool.threadCoordinate = model.strand.place[node];
    tool.closed = true;
    tool.jaw = input.tools[hand].jaw = 0.0;
    way_[hand] = Vec3(outward.x() > 0.0 ? 1.0 : -1.0, 0.0, 0.0);
    // The tool comes from the side to which it draws, its jaws opening across the thread: shaft along `way`.
    tool.device = tool.proxy = input.tools[hand].pose = frame(state.strand.position[node], Vec3::UnitY(), way_[hand].cross(Vec3::UnitY()));
  }
};

}  // namespace halsted
