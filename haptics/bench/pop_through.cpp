/// 5: hands that throw a tool at a sheet of tissue at 300 mm/s never get to its other side.
#include <algorithm>

#include "haptics/bench/bench.h"
#include "haptics/bench/block.h"

namespace halsted::haptics::bench {

namespace {

constexpr double kSpeed = 0.3;                 // [m/s] devices.md 5
constexpr double kFrom = 6e-3, kTo = -6e-3;    // [m] of the jaws' end above the sheet: where the hands start and what they aim at
constexpr int kThere = 40, kBack = 45;         // ticks
constexpr double kHeld = 0.3;                  // [N] a sheet that was not passed pushes with more at the end of the throw
constexpr double kPulled = 0.1;                // [N] toward the sheet on the way out: the tool hangs on its other side

BlockShape sheet(double thickness, int layers) {   // [m]
  BlockShape shape;
  shape.size = Vec3(20e-3, 20e-3, thickness);
  shape.nx = shape.ny = 8;
  shape.nz = layers;
  shape.sheet = true;
  return shape;
}

/// Numbers without a library's generator: the same on every machine.
struct Dice {
  std::uint64_t state = 7;
  double operator()() {                        // [1] in [-1, 1)
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state >> 11) / 4503599627370496.0 - 1.0;
  }
};

HandDynamics thrower() {
  HandDynamics hand = threeHands()[1].dynamics;
  hand.maxSpeed = kSpeed;
  hand.maxAcceleration = 100.0;                // at speed before the sheet
  return hand;
}

/// One hand's throws, each at another place of its half.
struct Thrower {
  explicit Thrower(double s) : side(s), rig({}, thrower(), above(4e-3 * s, 0.0, kFrom)) { rig.state.limits.ramp = 1.0; }

  void choose(Dice& dice) {
    x = side * (4e-3 + 2e-3 * dice());
    y = 5e-3 * dice();
    atEnd = pulled = 0.0;
  }
  void aim(double gap) { rig.target.pose = above(x, y, gap); }     // [m]
  void advance(const LocalContact& contact, bool back) {
    rig.contact = contact;
    rig.tickOnly();
    if (back) pulled = std::max(pulled, -rig.output.force.z());
    else atEnd = rig.output.force.z();
  }
  bool popped() const { return atEnd < kHeld || pulled > kPulled; }

  double side;                                 // [1]
  Rig rig;
  double x = 0.0, y = 0.0;                     // [m]
  double atEnd = 0.0, pulled = 0.0;            // [N] up when the throw is over; largest down on the way out
};

int poppedOf(const BlockShape& shape, int throws, const Heard& heard) {
  const Model model = blockModel(shape);
  Thrower hands[kHands] = {Thrower(1.0), Thrower(-1.0)};
  BlockStep block(model, {above(4e-3, 0.0, kFrom), above(-4e-3, 0.0, kFrom)});
  Dice dice;
  int popped = 0;
  const auto advance = [&](int ticks, bool back) {
    for (int k = 0; k < ticks; ++k) {
      for (int i = 0; i < kHands; ++i) {
        hands[i].advance(block.output.contact[i], back);
        block.input.tools[i] = hands[i].rig.output.sample;
      }
      block.stepBoth();
    }
  };
  for (int done = 0; done < throws; done += kHands) {
    if (heard) heard(static_cast<double>(done) / throws);
    for (Thrower& hand : hands) hand.choose(dice), hand.aim(kFrom);
    advance(kBack, true);                      // over the place
    for (Thrower& hand : hands) hand.aim(kTo);
    advance(kThere, false);
    for (Thrower& hand : hands) hand.aim(kFrom);
    advance(kBack, true);
    for (const Thrower& hand : hands) popped += hand.popped();
  }
  return popped;
}

}  // namespace

Measurements measurePopThrough(int throws, const Heard& heard) {
  Measurements all;
  const std::string count = std::to_string(throws) + " throws at 300 mm/s at ";
  all.push_back({"popped through", count + "2 mm of bowel, 1 MPa", static_cast<double>(poppedOf(sheet(2e-3, 1), throws, heard)), "times", Bound::kAtMost, 0.0});
  all.push_back({"popped through", count + "4 mm of bowel, 1 MPa", static_cast<double>(poppedOf(sheet(4e-3, 2), throws, heard)), "times", Bound::kAtMost, 0.0});
  return all;
}

}  // namespace halsted::haptics::bench
