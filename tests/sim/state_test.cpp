/// Laws of the state's one field list: what is saved comes back, and no bit can change unseen.
#include "sim/state.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <memory>

#include "sim/fields.h"

namespace halsted {
namespace {

State smallState() {
  State s;
  s.tissue.position.assign(13, Vec3(1, 2, 3));
  s.tissue.velocity.assign(13, Vec3::Zero());
  s.tissue.rotation.assign(12, Quat::Identity());
  s.tissue.pressure.assign(40, 0.5);
  s.strand.position.assign(5, Vec3::Zero());
  s.strand.velocity.assign(5, Vec3::Zero());
  s.strand.tension.assign(4, 0.0);
  return s;
}

/// Flips one bit of the `target`-th scalar of the list.
struct Flip {
  std::size_t target, seen = 0;
  std::string path{};

  template <class T> void leaf(const FieldPath& where, T* data, std::size_t count, int) {
    if (target >= seen && target < seen + count) {
      path = where.text();
      flip(data[target - seen], static_cast<unsigned>(target));
    }
    seen += count;
  }
  void size(const FieldPath&, std::size_t) {}

 private:
  static void flip(bool& x, unsigned) { x = !x; }
  static void flip(double& x, unsigned bit) { x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (1ULL << bit % 64)); }
  template <class T> static void flip(T& x, unsigned bit) { x = static_cast<T>(x ^ (T{1} << bit % (8 * sizeof(T) - 1))); }
};

std::size_t scalars(State s) {
  Flip none{~std::size_t{0}};
  visitFields(s, none);
  return none.seen;
}

TEST(StateFields, AFlippedBitInAnyScalarChangesTheHashAndIsNamedByTheDiff) {
  const State original = smallState();
  const std::uint64_t before = hash(original);
  const std::size_t count = scalars(original);
  ASSERT_GT(count, 2000u);
  for (std::size_t i = 0; i < count; ++i) {
    State changed = original;
    Flip flip{i};
    visitFields(changed, flip);
    ASSERT_NE(hash(changed), before) << flip.path;
    ASSERT_EQ(diff(original, changed).rfind(flip.path, 0), 0u) << "expected " << flip.path << ", got " << diff(original, changed);
  }
}

/// Marks the bytes of an object that the field list reaches.
struct Coverage {
  const unsigned char* begin;
  std::vector<char> seen;

  template <class T> void leaf(const FieldPath&, T* data, std::size_t count, int) {
    const std::ptrdiff_t from = reinterpret_cast<const unsigned char*>(data) - begin;
    if (from < 0 || from >= static_cast<std::ptrdiff_t>(seen.size())) return;   // on the heap: reached through its vector
    std::memset(seen.data() + from, 1, count * sizeof(T));
  }
  void size(const FieldPath&, std::size_t) {}
  void holder(const void* vector, std::size_t length) { mark(vector, length); }   // the vector's own pointers
  void mark(const void* object, std::size_t length) {
    std::memset(seen.data() + (static_cast<const unsigned char*>(object) - begin), 1, length);
  }
};

TEST(StateFields, EveryByteOutsideVectorsIsInTheListOrPadding) {
  State s = smallState();
  s.strand.holeCount = StrandState::kMaxHoles;   // all of every table is in use
  s.threadContacts.drag.assign(1, 0.0);        // a scene whose thread meets itself
  s.tissue.gone.assign(1, 0);                  // whose tissue can be cut
  s.strand.comesThrough.assign(1, 0);          // and a thread that cannot be knotted
  s.threadContacts.count = ThreadContactState::kMaxContacts;
  s.knot.watched = true;
  Coverage coverage{reinterpret_cast<const unsigned char*>(&s), std::vector<char>(sizeof s, 0)};
  coverage.mark(&s.work, sizeof s.work);       // scratch is no part of the state's value
  visitFields(s, coverage);
  std::size_t run = 0;
  for (std::size_t i = 0; i < sizeof s; ++i) {
    run = coverage.seen[i] ? 0 : run + 1;
    ASSERT_LT(run, 8u) << "byte " << i << " of State is neither listed nor alignment padding";
  }
}

/// Everything that can be there, in memory that held something else before.
std::uint64_t hashOver(unsigned char before) {
  std::vector<unsigned char> memory(sizeof(State) + alignof(State));
  volatile unsigned char* byte = memory.data();  // else the compiler knows that nobody may look at it
  for (std::size_t i = 0; i < memory.size(); ++i) byte[i] = before;
  void* place = memory.data();
  std::size_t room = memory.size();
  State* s = new (std::align(alignof(State), sizeof(State), place, room)) State;
  s->threadContacts.drag.assign(1, 0.0);
  s->threadContacts.count = ThreadContactState::kMaxContacts;
  s->strand.holeCount = StrandState::kMaxHoles;
  s->knot.watched = true;
  s->assist.emplace();
  s->stitches.emplace().count = TiedStitches::kMost;
  s->supply.emplace();
  s->cut.emplace();
  s->instruments.emplace();
  s->clamps.emplace();
  s->needling.emplace();
  s->metrics.seam.emplace();
  s->metrics.cut.emplace();
  s->metrics.needling.emplace();
  const std::uint64_t sum = hash(*s);
  s->~State();
  return sum;
}

TEST(StateFields, ANewStateHoldsNothingOfWhatLayInItsMemory) { EXPECT_EQ(hashOver(0x11), hashOver(0xee)); }

TEST(StateFields, NamesFollowTheDeclarations) {
  State a = smallState();
  a.strand.holeCount = 4;
  const auto named = [&](auto change) {
    const auto b = std::make_unique<State>(a);   // a megabyte: fourteen of them are more than a stack holds
    change(*b);
    return diff(a, *b).substr(0, diff(a, *b).find(':'));
  };
  EXPECT_EQ(named([](State& s) { s.random = 9; }), "random");
  EXPECT_EQ(named([](State& s) { s.tissue.position[7].y() = 9; }), "tissue.position[7].y");
  EXPECT_EQ(named([](State& s) { s.tissue.rotation[3].w() = 0.9; }), "tissue.rotation[3].w");
  EXPECT_EQ(named([](State& s) { s.strand.holes[3].bite = 9; }), "strand.holes[3].bite");
  EXPECT_EQ(named([](State& s) { s.strand.holes[3].weight[2] = 9; }), "strand.holes[3].weight[2]");
  EXPECT_EQ(named([](State& s) { s.strand.contacts[8].feature = 9; }), "strand.contacts[8].feature");
  EXPECT_EQ(named([](State& s) { s.strand.bitesBegun = 9; }), "strand.bitesBegun");
  EXPECT_EQ(named([](State& s) { s.tools[1].proxy.position.z() = 9; }), "tools[1].proxy.position.z");
  EXPECT_EQ(named([](State& s) { s.tools[0].grasp.force[2].x() = 9; }), "tools[0].grasp.force[2].x");
  EXPECT_EQ(named([](State& s) { s.tools[0].threadCoordinate = 9; }), "tools[0].threadCoordinate");
  EXPECT_EQ(named([](State& s) { s.procedure.faults[4] = 9; }), "procedure.faults[4]");
  EXPECT_EQ(named([](State& s) { s.metrics.hands[1].started = true; }), "metrics.hands[1].started");
  EXPECT_EQ(named([](State& s) { s.metrics.bites[2].width = 9; }), "metrics.bites[2].width");
  EXPECT_EQ(named([](State& s) { s.metrics.restOpeningArea = 9; }), "metrics.restOpeningArea");
}

TEST(StateFields, DiffPrintsBothValuesWithAllDigits) {
  State a = smallState(), b = a;
  b.tissue.velocity[2].z() = 0.1;
  EXPECT_EQ(diff(a, b), "tissue.velocity[2].z: 0 and 0.10000000000000001");
  EXPECT_EQ(diff(a, a), "");
}

TEST(StateFields, DiffNamesAVectorOfAnotherLength) {
  State a = smallState(), b = a;
  b.strand.tension.push_back(0.0);
  EXPECT_EQ(diff(a, b), "strand.tension.size: 4 and 5");
  EXPECT_NE(hash(a), hash(b));
}

TEST(StateFields, FlippedSignsDoNotCancelInTheHash) {
  const State a = smallState();
  for (int i = 0; i < 12; ++i) {
    State b = a;
    b.tissue.position[i].x() *= -1.0;
    b.tissue.position[i + 1].x() *= -1.0;
    EXPECT_NE(hash(a), hash(b));
  }
}

TEST(StateFields, LoadRestoresWhatSaveStored) {
  State a = smallState();
  for (std::size_t i = 0; i < scalars(a); i += 3) {
    Flip flip{i};
    visitFields(a, flip);
  }
  State b = smallState();
  std::string error;
  ASSERT_TRUE(load(save(a), b, error)) << error;
  EXPECT_EQ(diff(a, b), "");
  EXPECT_EQ(hash(a), hash(b));
}

TEST(StateFields, LoadRefusesDataOfAnotherSizeAndLeavesTheStateAlone) {
  const State a = smallState();
  State larger = a;
  larger.strand.tension.push_back(0.0);
  std::string error;
  State b = larger;
  EXPECT_FALSE(load(save(a), b, error));
  EXPECT_EQ(error, "strand.tension: 4 items in the data, 5 in this scene");
  EXPECT_EQ(diff(b, larger), "");

  std::vector<std::uint8_t> bytes = save(a);
  for (std::size_t cut = 0; cut < bytes.size(); cut += 7) {
    State c = a;
    EXPECT_FALSE(load({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(cut)}, c, error));
    EXPECT_FALSE(error.empty());
  }
  bytes.push_back(0);
  State d = a;
  EXPECT_FALSE(load(bytes, d, error));
}

TEST(StateFields, LoadRefusesABooleanThatIsNone) {
  State a = smallState();
  std::vector<std::uint8_t> bytes = save(a), flipped;
  a.procedure.late = true;
  flipped = save(a);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (bytes[i] != flipped[i]) bytes[i] = 7;
  std::string error;
  EXPECT_FALSE(load(bytes, a, error));
  EXPECT_EQ(error, "procedure.late: neither true nor false");
}

}  // namespace
}  // namespace halsted
