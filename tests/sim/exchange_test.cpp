/// What many contacts and holes together do to one place of the tissue, against the sum over all of them one by one.
#include "sim/suture/exchange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/sim/threaded_wall.h"

namespace halsted {
namespace {

struct Pressed : ThreadedWall {
  ExchangeWork work;
  Pressed() : ThreadedWall(frame(Vec3(-12.7e-3, 12.3e-3, 9.2e-3) - 26e-3 / std::numbers::pi * Vec3::UnitZ(), Vec3::UnitZ(), -Vec3::UnitX())) {
    thread({{-12.7e-3, 12.3e-3, 9.2e-3}, {0.5, 12.3e-3, 9.2e-3}});
  }
  int cornerOf(int triangle) const { return model.surface.triangles[triangle][1]; }
  void press(int sample, int triangle) { state.strand.contacts[state.strand.contactCount++] = {sample, triangle, 0.1, Vec3::UnitZ(), {0.2, 0.5, 0.3}}; }
  /// The n-th triangle whose second corner can move.
  int freeTriangle(int n) const {
    for (int t = 0;; ++t)
      if (give(cornerOf(t), cornerOf(t)) > 0.0 && n-- == 0) return t;
  }
  double give(int a, int b) const { return std::fabs(compliance(model.tissue.projective, a, b)); }   // [m/N]
};

TEST(Exchange, ContactsOfThreadAndNeedleAddUpAndSteelIsNotAmongThem) {
  Pressed w;
  w.state.strand.contactCount = 0;
  const int many = w.freeTriangle(0), one = w.freeTriangle(9);
  for (int sample : {3, 4, 5}) w.press(sample, many);
  w.press(9, one);
  w.press(w.model.strand.nodes, one);           // the needle's first sample
  w.press(10, static_cast<int>(w.model.surface.triangles.size()));   // steel, not tissue
  gatherExchange(w.model, w.state.strand, w.work);
  const int here = w.cornerOf(w.freeTriangle(5));
  const double sum = 3.0 * w.give(here, w.cornerOf(many)) + 2.0 * w.give(here, w.cornerOf(one));   // [m/N]
  ASSERT_GT(sum, 0.0);
  for (int again = 0; again < 2; ++again) EXPECT_NEAR(movedByContacts(w.model, here, w.work), sum, 1e-12 * sum);
}

TEST(Exchange, HolesAddUp) {
  Pressed w;
  ASSERT_GE(w.state.strand.holeCount, 2);
  gatherExchange(w.model, w.state.strand, w.work);
  double sum = 0.0;                            // [m/N]
  const int here = w.cornerOf(w.freeTriangle(5));
  for (int h = 0; h < w.state.strand.holeCount; ++h) sum += w.give(here, vertexOf(w.model, w.state.strand.holes[h]));
  EXPECT_NEAR(movedByHoles(w.model, here, w.work), sum, 1e-12 * sum);
}

}  // namespace
}  // namespace halsted
