#pragma once
/// Loosely laced knots by geometry, hands that pull with a wanted force, and a tensile test of what they tied.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "tests/sim/knot_rig.h"

namespace halsted {

/// Size of the loosely laced knot before it is tightened.
struct Lacing {
  double radius = 0.5e-3;                      // [m] of the helix of a throw
  double half = 1.6e-3;                        // [m] half the length of a throw
  double loop = 7e-3;                          // [m] radius of the loop's ends
  double tail = 10e-3;                         // [m]
};

/// Throws stacked upward on a loop. Each is a number of half twists with the sign of their hand: 3 a single throw, 5 a surgeon's double.
/// The strand runs tail, throws downward, loop, throws upward, tail. `loopStart` and `loopEnd` receive the nodes where the loop begins and ends.
class LooseKnot {
 public:
  LooseKnot(std::span<const int> halfTwists, const Lacing& lacing) : throws_(halfTwists.begin(), halfTwists.end()), l_(lacing) {}

  std::vector<Vec3> nodes(double segment) const {   // [m]
    std::vector<Vec3> fine = strand(+1), other = strand(-1);
    std::reverse(fine.begin(), fine.end());    // from its tail down to the loop
    const double y = -l_.radius;               // [m]
    for (int i = 0; i <= 400; ++i) {           // right end of the loop to left end: the first strand enters from the right
      const double t = kPi * i / 400.0;        // [rad]
      fine.push_back(Vec3(l_.half + l_.loop * std::sin(t), y - l_.loop * (1.0 - std::cos(t)), 0.0));
    }
    for (int i = 0; i <= 400; ++i) {
      const double t = kPi * i / 400.0;        // [rad]
      fine.push_back(Vec3(-l_.half - l_.loop * std::sin(t), y - l_.loop * (1.0 + std::cos(t)), 0.0));
    }
    fine.insert(fine.end(), other.begin(), other.end());
    return evenlySpaced(fine, segment);
  }
  /// The node where a hand takes the loop, between the knot and the loop's end; side +1 right, -1 left.
  int loopNode(const std::vector<Vec3>& nodes, int side) const {
    const double reach = 2.5e-3;               // [m] near the knot: the far side of the loop stays slack
    const Vec3 target(side * (l_.half + reach), -l_.radius - 0.5 * reach * reach / l_.loop, 0.0);
    int best = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if ((nodes[i] - target).squaredNorm() < (nodes[best] - target).squaredNorm()) best = static_cast<int>(i);
    return best;
  }

 private:
  static constexpr double kPi = 3.14159265358979312;

  /// One strand upward from the loop's end on `side`, through every throw, to its tail.
  std::vector<Vec3> strand(int side) const {
    std::vector<Vec3> out;
    const double rise = 4.0 * l_.radius;       // [m] between throws
    for (std::size_t k = 0; k < throws_.size(); ++k) {
      const double height = rise * k;          // [m]
      for (int i = 0; i <= 400; ++i) {
        const double u = i / 400.0, x = side > 0 ? 1.0 - 2.0 * u : 2.0 * u - 1.0;   // [1]
        const double turn = kPi + throws_[k] * kPi * 0.5 * (x + 1.0) + (side > 0 ? kPi : 0.0);   // [rad]
        out.push_back(Vec3(l_.half * x, height + l_.radius * std::cos(turn), l_.radius * std::sin(turn)));
      }
      side = -side;
      if (k + 1 == throws_.size()) break;
      for (int i = 1; i < 100; ++i) {          // round the outside to the next throw; `side` now names where it enters
        const double t = kPi * i / 100.0;      // [rad]
        out.push_back(Vec3(side * (l_.half + l_.radius * std::sin(t)), height + l_.radius + l_.radius * (1.0 - std::cos(t)), 0.0));
      }
    }
    const Vec3 end = out.back();
    for (int i = 1; i <= 100; ++i) out.push_back(end + Vec3(side * l_.tail * i / 100.0, 0.15 * l_.tail * i / 100.0, 0.0));
    return out;
  }

  std::vector<int> throws_;
  Lacing l_;
};

/// A hand on a node: moves along `direction` as fast as it may until it feels the wanted force.
struct PullingHand {
  std::size_t link = 0;
  Vec3 direction = Vec3::UnitX();              // [1]
  double speed = 0.2;                          // [m/s]
  double wanted = 0.0, felt = 0.0;             // [N]
};

/// A knot on a loop: tails pulled to tighten, then the loop's two sides pulled apart as a tensile tester does.
class TiedKnot {
 public:
  KnotRig rig;
  int leftLoop, rightLoop;
  std::vector<PullingHand> hands;

  TiedKnot(std::span<const int> throws, const ThreadContactParams& contact = {}, const SimParams& p = knotThread(), const Lacing& lacing = {})
      : TiedKnot(LooseKnot(throws, lacing), contact, p) {}

  /// All four ends pulled with the same force.
  void tighten(double force, double seconds) {   // [N], [s]
    hands.clear();
    const int last = rig.model.nodes - 2;
    // A tail leaves on the side where the last throw put it.
    const double firstSide = rig.state.position[0].x() > rig.state.position[40].x() ? 1.0 : -1.0;   // [1]
    take(0, firstSide * Vec3::UnitX(), force);
    take(last, -firstSide * Vec3::UnitX(), force);
    take(leftLoop, -Vec3::UnitX(), force);
    take(rightLoop, Vec3::UnitX(), force);
    run(seconds);
  }
  struct Loading {
    double most = 0.0;                         // [N] the largest force that both hands felt
    double gained = 0.0;                       // [m] by which the loop opened
    bool held = false;                         // the wanted force stands and nothing moves any more
    bool solved = false;                       // to the end: without this the rest says nothing
    bool slipped() const { return solved && !held; }
  };
  /// Lets the tails go and pulls the loop apart up to `force` at `speed`, until it stands or has opened by 6 mm: 3 mm of each tail.
  Loading load(double force, double speed, double seconds = 0.5) {   // [N], [m/s], [s]
    release();
    take(leftLoop, -Vec3::UnitX(), force);
    take(rightLoop, Vec3::UnitX(), force);
    for (PullingHand& h : hands) h.speed = speed;
    const double before = opening();           // [m]
    double last = before;                      // [m]
    Loading r;
    for (int k = 1; k < seconds / rig.dt && r.gained < 6e-3 && !r.held; ++k) {
      if (!step()) return r;
      r.most = std::max(r.most, std::min(hands[0].felt, hands[1].felt));
      r.gained = opening() - before;
      if (k % 100) continue;
      r.held = std::min(hands[0].felt, hands[1].felt) > 0.99 * force && std::fabs(opening() - last) < 20e-6;
      last = opening();
    }
    r.solved = true;
    return r;
  }
  void release() {
    hands.clear();
    rig.held.clear();
  }

  /// Between the two hands on the loop: thread gets there only through the knot.
  double opening() const { return (rig.state.position[leftLoop] - rig.state.position[rightLoop]).norm(); }   // [m]

  bool step() {
    for (PullingHand& h : hands) {
      const double lack = (h.wanted - h.felt) / (0.25 * h.wanted);   // [1]
      rig.held[h.link].anchor += std::clamp(lack, -1.0, 1.0) * h.speed * rig.dt * h.direction;
    }
    if (!rig.step()) return false;
    for (PullingHand& h : hands) h.felt = rig.forceOf(h.link).dot(h.direction);
    return true;
  }
  void run(double seconds) {                   // [s]
    for (int k = 0; k < seconds / rig.dt; ++k)
      ASSERT_TRUE(step()) << "the strand could not be solved";
  }

 private:
  TiedKnot(const LooseKnot& knot, const ThreadContactParams& contact, const SimParams& p) : TiedKnot(knot, knot.nodes(p.thread.segmentLength), contact, p) {}
  TiedKnot(const LooseKnot& knot, const std::vector<Vec3>& nodes, const ThreadContactParams& contact, const SimParams& p)
      : rig(p, nodes, contact), leftLoop(knot.loopNode(nodes, -1)), rightLoop(knot.loopNode(nodes, 1)) {}

  void take(int node, const Vec3& direction, double force) {   // [1], [N]
    hands.push_back({rig.hold(node, 2e3), direction, 0.2, force, 0.0});
  }
};

}  // namespace halsted
