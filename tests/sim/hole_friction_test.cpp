/// Thread that turns back at a hole: it comes through toward the tauter leg once that pulls more than the capstan holds, and not before.
#include "sim/suture/hole_friction.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/sim/threaded_wall.h"

namespace halsted {
namespace {

/// A hole between nodes 20 and 21, `turn` between the two legs.
struct Turned : ThreadedWall {
  explicit Turned(double turn) : ThreadedWall(kNeedleAway) {   // [rad]
    const double segment = model.strand.segment;               // [m]
    state.strand.holeCount = 1;
    Hole& hole = state.strand.holes[0];
    hole.coordinate = 20.5 * segment;
    hole.tet = 0;
    for (int i = 0; i < model.strand.nodes; ++i) {
      const double along = (i - 20.5) * segment;               // [m]
      state.strand.position[i] = along < 0.0 ? Vec3(along * Vec3::UnitX()) : Vec3(along * Vec3(std::cos(turn), std::sin(turn), 0.0));
    }
  }
  std::optional<double> creep(double before, double after) {   // [N]
    for (int i = 0; i + 1 < model.strand.nodes; ++i) state.strand.tension[i] = i <= 20 ? before : after;
    return creepRound(model, state.strand, 0);                 // [m]
  }
};

TEST(HoleFriction, ThreadTurnedBackCreepsTowardTheTauterLeg) {
  Turned w(0.9 * std::numbers::pi);
  EXPECT_LT(w.creep(0.1, 2.0).value(), 0.0);   // the hole comes to lie nearer to the tail
  EXPECT_GT(w.creep(2.0, 0.1).value(), 0.0);
  EXPECT_DOUBLE_EQ(w.creep(0.1, 2.0).value(), -w.creep(2.0, 0.1).value());
  EXPECT_LE(w.creep(0.0, 1000.0).value(), kMostSlide);
}

TEST(HoleFriction, ThreadTurnedBackStaysBelowTheCapstan) {
  Turned w(0.9 * std::numbers::pi);
  const double ratio = std::exp(w.model.params.contact.threadTissueFriction * 0.9 * std::numbers::pi);   // [1]
  EXPECT_EQ(w.creep(1.0, 0.98 * ratio).value(), 0.0);
  EXPECT_LT(w.creep(1.0, 1.05 * ratio).value(), 0.0);
}

TEST(HoleFriction, ElsewhereItIsLeftToTheSolve) {
  EXPECT_FALSE(Turned(0.2 * std::numbers::pi).creep(0.1, 2.0));
}

}  // namespace
}  // namespace halsted
