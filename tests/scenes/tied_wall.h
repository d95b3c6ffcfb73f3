#pragma once
/// The standing wall of tests/sim with one stitch through it, thread fine where a knot comes to lie, and the scripted surgeon who ties it.
/// The whole step runs: tissue, holes, thread against itself and against both tools.
#include <string>
#include <vector>

#include "scenes/expert.h"
#include "sim/strand/knot_diagram.h"
#include "tests/sim/threaded_wall.h"

namespace halsted {

inline SimParams tiedWallParams(double gravity = 0.0) {   // [m/s^2]
  SimParams p = wallParams();
  p.gravity.z() -= gravity;
  p.needle.tearForce = 50.0;                   // the knot is what is tested
  p.thread.nodes = 66;
  p.thread.fineFrom = 10e-3;
  p.thread.fineTo = 60e-3;
  p.thread.fineSegment = 0.4e-3;
  p.thread.knots = true;
  return p;
}

struct TiedWall : ThreadedWall {
  std::string failure;                         // of the last script
  std::vector<std::string> read;               // what the thread was read as, one after the other
  KnotState last;                              // as it was read

  explicit TiedWall(const SimParams& p = tiedWallParams()) : ThreadedWall(kNeedleAway, p) {
    layStitch();
    openHoles();
    ToolState& driver = state.tools[kRight];   // nothing in its jaws
    driver.holdsNeedle = driver.closed = driver.ratchet = false;
    for (int hand = 0; hand < kHands; ++hand) {
      ToolState& tool = state.tools[hand];
      tool.jaw = input.tools[hand].jaw = 1.0;
      tool.device = tool.proxy = input.tools[hand].pose = Pose{Vec3(hand == kLeft ? -0.06 : 0.06, 0.02, 0.055), Quat::Identity()};
    }
  }

  /// Lets the surgeon do what the actions say; true when all were done.
  bool act(const std::string& actions) {
    const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n" + actions, "test");
    const scenes::ExpertStatePtr memory = scenes::beginExpert(script, model);
    for (bool more = true; more;) {
      more = advance(script, *memory);
      if (!finite()) failure = "not finite";
      if (!failure.empty()) return false;
    }
    return true;
  }
  bool advance(const scenes::ExpertScript& script, scenes::ExpertState& memory) {
    std::array<HandTarget, kHands> target;
    const bool more = scenes::advanceExpert(script, model, state, memory, target, failure);
    follow(target);
    step();
    if (state.knot.turns != last.turns || state.knot.sense != last.sense) read.push_back(knotName(readKnot(state.strand.position)));
    last = state.knot;
    return more;
  }
  /// The hands go where the surgeon wants them.
  void follow(const std::array<HandTarget, kHands>& target) {
    for (int hand = 0; hand < kHands; ++hand) {
      if (!target[hand].valid) continue;
      input.tools[hand].pose = target[hand].pose;
      input.tools[hand].jaw = target[hand].jaw;
    }
  }
  double seen(Quantity q) const { return out.seen[static_cast<int>(q)]; }   // unit of the quantity

 private:
  /// Tail 26 mm out to the -x side, the long end up on the +x side.
  void layStitch() {
    const Vec3 corners[] = {{-26e-3, 12.1e-3, 16e-3}, {0, 12.1e-3, 12.1e-3}, {kWallX, 12.1e-3, 12.1e-3}, {24e-3, 12.1e-3, 20e-3},
                            {60e-3, 12.1e-3, 60e-3}, {60e-3, 12.1e-3, 260e-3}};
    std::size_t leg = 0;
    double before = 0.0;                       // [m] of the path up to this leg
    for (int i = 0; i < model.strand.nodes; ++i) {
      while (model.strand.place[i] > before + (corners[leg + 1] - corners[leg]).norm()) {
        before += (corners[leg + 1] - corners[leg]).norm();
        ++leg;
      }
      const Vec3 d = corners[leg + 1] - corners[leg];
      state.strand.position[i] = corners[leg] + (model.strand.place[i] - before) / d.norm() * d;
    }
    Pose& needle = state.strand.needle;
    needle.orientation = turnOnto(model.strand.arcTangent.front(), Vec3::UnitZ());
    needle.position += state.strand.position.back() - needle.apply(model.strand.arcPoint.front());
  }
};

}  // namespace halsted
