/// 5: a tool thrown through a thin sheet of bowel at 300 mm/s never gets to its other side.
#include <algorithm>
#include <cmath>

#include "haptics/bench/bench.h"
#include "haptics/bench/block.h"
#include "haptics/bench/driven.h"

namespace halsted::haptics::bench {

namespace {

constexpr double kSpeed = 0.3;                 // [m/s] devices.md 5
constexpr double kFrom = 3e-3, kTo = -6e-3;    // [m] of the jaws' end: from above the sheet to 4 mm beyond its far face
constexpr double kHeld = 0.3;                  // [N] at the far end a sheet that was not passed pushes with more
constexpr double kPulled = 0.1;                // [N] toward the sheet on the way out: the tool hangs on its other side

BlockShape thinSheet() {
  BlockShape shape;
  shape.size = Vec3(20e-3, 20e-3, 2e-3);       // [m] the wall of the colon
  shape.nx = shape.ny = 8;
  shape.nz = 1;
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

/// One hand's crossings: down and up again at constant speed, each at another place.
struct Crosser {
  DrivenRig rig;
  double x = 0.0, y = 0.0, side = 1.0;         // [m] [m] [1] half of the sheet that is this hand's
  double deepest = 0.0, pulled = 0.0;          // [N] force up at the far end; largest force down on the way out

  /// Position after `travelled` [m] of the way there and back.
  Vec3 at(double travelled) const {
    const double down = kFrom - kTo;           // [m]
    return above(x, y, travelled < down ? kFrom - travelled : kTo + (travelled - down)).position;
  }
  void choose(Dice& dice) {
    x = side * (3.5e-3 + 2e-3 * dice());
    y = 5e-3 * dice();
    deepest = pulled = 0.0;
  }
  void tickAt(double travelled, const LocalContact& contact) {   // [m]
    rig.contact = contact;
    const double up = rig.tickAt(at(travelled)).z();             // [N]
    const double down = kFrom - kTo;                             // [m]
    if (std::abs(travelled - down) < 1e-3) deepest = std::max(deepest, up);
    if (travelled > down) pulled = std::max(pulled, -up);
  }
  bool popped() const { return deepest < kHeld || pulled > kPulled; }
};

}  // namespace

Measurements measurePopThrough(int crossings) {
  const Model model = blockModel(thinSheet());
  Crosser hands[kHands];
  hands[kRight].side = -1.0;
  Dice dice;
  BlockStep block(model, {above(3e-3, 0.0, kFrom), above(-3e-3, 0.0, kFrom)});
  int popped = 0;
  double weakest = 1e9;                        // [N]
  const double step = kSpeed * model.params.dt, way = 2.0 * (kFrom - kTo);   // [m] [m]
  for (int done = 0; done < crossings; done += kHands) {
    for (Crosser& hand : hands) hand.choose(dice);
    for (double travelled = 0.0; travelled < way; travelled += step) {       // [m]
      for (int i = 0; i < kHands; ++i) {
        hands[i].tickAt(travelled, block.output.contact[i]);
        block.input.tools[i] = hands[i].rig.output.sample;
      }
      block.stepBoth();
    }
    for (const Crosser& hand : hands) {
      popped += hand.popped();
      weakest = std::min(weakest, hand.deepest);
    }
  }
  const std::string condition = std::to_string(crossings) + " crossings of 2 mm of bowel at 300 mm/s";
  return {{"popped through", condition, static_cast<double>(popped), "times", Bound::kAtMost, 0.0},
          {"weakest force 4 mm beyond the far face", condition, weakest, "N"}};
}

}  // namespace halsted::haptics::bench
