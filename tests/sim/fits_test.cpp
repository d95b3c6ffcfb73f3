/// A state from a damaged file: every index and count that a step would follow is refused, and what is not refused can be stepped.
#include "sim/fits.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <set>

#include "sim/fields.h"
#include "tests/sim/cut_rig.h"
#include "tests/sim/hand_noise.h"
#include "tests/sim/laced_wall.h"

namespace halsted {
namespace {

/// One run of integers in the saved form.
struct Place {
  std::string field;
  std::size_t at = 0, count = 0, size = 0;     // bytes from the beginning; integers; bytes of each
};

/// All of them, the first of each name only where `once`.
struct Places {
  bool once = false;
  std::vector<Place> found{};
  std::size_t at = 0;
  std::set<std::string> seen{};

  template <class T> void leaf(const FieldPath& path, const T*, std::size_t count, int) {
    std::string name;
    bool index = false;
    for (char c : path.text()) {
      index = (index || c == '[') && c != ']';
      if (!index && c != ']') name += c;
    }
    if (std::is_integral_v<T> && !std::is_same_v<T, bool> && (seen.insert(name).second || !once)) found.push_back({name, at, count, sizeof(T)});
    at += count * sizeof(T);
  }
  void size(const FieldPath&, std::size_t) { at += 8; }
};

std::vector<Place> placesOf(State s, bool once) {
  Places places{once};
  visitFields(s, places);
  return places.found;
}

void write(std::vector<std::uint8_t>& bytes, const Place& p, std::size_t item, std::int64_t value) {
  std::memcpy(&bytes[p.at + item * p.size], &value, p.size);     // the low bytes come first
}

/// As a reader of sessions does.
bool accepted(const Model& m, const std::vector<std::uint8_t>& bytes, State& s, std::string& error) { return load(bytes, s, error) && fits(m, s, error); }

/// Of these no value is refused: what counts steps or is drawn by chance, and counts that the field list itself puts right (sim/fields.h).
bool free(const std::string& field) {
  static const std::set<std::string> kFree = {"step", "random", "strand.holeCount", "threadContacts.count", "knot.throws", "stitches.count"};
  return kFree.contains(field);
}
bool anySign(const std::string& field) { return field == "knot.turns" || field == "knot.toolTurns"; }

void expectRefusedWhereDamaged(const Model& m, const State& good) {
  std::string error;
  ASSERT_TRUE(fits(m, good, error)) << error;
  const std::vector<std::uint8_t> bytes = save(good);
  State s = good;
  for (const Place& p : placesOf(good, true)) {
    if (free(p.field)) continue;
    for (const std::int32_t value : {-100, std::numeric_limits<std::int32_t>::max()}) {
      if (value == -100 && anySign(p.field)) continue;
      std::vector<std::uint8_t> damaged = bytes;
      write(damaged, p, p.count - 1, p.size == 1 ? 0xfe : value);
      EXPECT_FALSE(accepted(m, damaged, s, error)) << p.field << " = " << value;
      EXPECT_FALSE(error.empty());
    }
  }
}

/// Thread in holes, laced into a knot that touches itself, held by two tools.
LacedWall laced() {
  LacedWall w(std::vector<int>{3, -3});
  w.drawTight(1.0, 0.1);
  return w;
}

/// A strip that has been cut into, and its pen.
CutRig cut() {
  CutRig rig;
  rig.saw(600);
  return rig;
}

/// Jaws closed on the edge of the wall, in a scene that may keep stitches, change instruments and hand clamps over.
StepRig grasping() {
  SimParams p = wallParams();
  p.thread.knots = true;
  p.thread.spare = 2;
  p.assistant.clamps = 2;
  p.second[kRight].kind = ToolKind::kForceps;
  StepRig rig(p, kNeedleAway, frame(Vec3(0.5 * kWallX, 12e-3, kWallZ - 1e-3), Vec3::UnitX(), Vec3::UnitY()));
  rig.run(10);
  rig.input.tools[kLeft].jaw = 0.0;
  rig.run(60);
  const TissuePoint holes[] = {tissuePointAt(rig.model, Vec3(1e-3, 8e-3, 12e-3)), tissuePointAt(rig.model, Vec3(3e-3, 8e-3, 12e-3))};
  EXPECT_TRUE(tieStitch(rig.model, rig.state, holes, 6e-3));
  rig.run(10);
  return rig;
}

TEST(Fits, NamesTheFieldWithAnIndexThatIsNone) {
  StepRig rig = grasping();
  std::string error;
  ASSERT_TRUE(fits(rig.model, rig.state, error)) << error;
  EXPECT_EQ(error, "");
  rig.state.tools[kLeft].contactTriangle[3] = 100000;
  EXPECT_FALSE(fits(rig.model, rig.state, error));
  EXPECT_EQ(error, "tools[0].contactTriangle[3]: 100000 cannot be");
  rig.state.tools[kLeft].contactTriangle[3] = 0;
  rig.state.tools[kRight].nearCount = 1;
  rig.state.tools[kRight].nearTriangle[0] = -1;
  EXPECT_FALSE(fits(rig.model, rig.state, error));
  EXPECT_EQ(error, "tools.nearCount: counts what is not there");
  rig.state.tools[kRight].nearCount = 0;
  rig.state.tissue.velocity[5].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fits(rig.model, rig.state, error));
  EXPECT_EQ(error.rfind("tissue.velocity[16]: ", 0), 0u) << error;
}

TEST(Fits, RefusesEveryIntegerThatAStepCouldNotFollow) {
  const LacedWall knotted = laced();
  ASSERT_GT(knotted.state.threadContacts.count, 0);
  ASSERT_GT(knotted.state.strand.holeCount, 0);
  expectRefusedWhereDamaged(knotted.model, knotted.state);
  const CutRig strip = cut();
  ASSERT_GT(strip.cut().burnt, 0);
  expectRefusedWhereDamaged(strip.model, strip.state);
  const StepRig held = grasping();
  ASSERT_GT(held.state.tools[kLeft].grasp.count, 0);
  expectRefusedWhereDamaged(held.model, held.state);
}

/// Values that are in range but wrong: the step may do anything with them but crash.
TEST(Fits, WhatIsAcceptedCanBeStepped) {
  LacedWall knotted = laced();
  StepRig held = grasping();
  for (StepRig* rig : {static_cast<StepRig*>(&knotted), &held}) {
    const std::vector<std::uint8_t> bytes = save(rig->state);
    const std::vector<Place> places = placesOf(rig->state, false);
    std::uint64_t random = 7;
    int stepped = 0;
    for (int k = 0; k < 80; ++k) {
      std::vector<std::uint8_t> damaged = bytes;
      for (int n = 0; n < 1 + k % 3; ++n) {
        random = random * 6364136223846793005ULL + 1442695040888963407ULL;
        const Place& p = places[(random >> 33) % places.size()];
        write(damaged, p, (random >> 20) % p.count, static_cast<std::int64_t>(random >> 50) % 300 - 2);
      }
      std::string error;
      if (!accepted(rig->model, damaged, rig->state, error)) continue;
      rig->run(2);
      ++stepped;
    }
    RecordProperty("stepped", stepped);
    EXPECT_GT(stepped, 20);
  }
}

}  // namespace
}  // namespace halsted
