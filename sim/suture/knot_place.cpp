#include "sim/suture/knot_place.h"

#include <algorithm>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted {
namespace {

constexpr double kPassedOver = 0.05;           // [1] of the push

struct Push { double away = 0.0, force = 0.0; };   // [m] of thread from the hole, [N]

struct Pushes {
  std::array<Push, ThreadContactState::kMaxContacts> item;
  int count = 0;
  double sum = 0.0;                            // [N]

  void add(double away, double force) {        // [m], [N]
    item[count++] = {away, force};
    sum += force;
  }
  void sort() {
    std::sort(item.begin(), item.begin() + count, [](const Push& a, const Push& b) { return a.away != b.away ? a.away < b.away : a.force < b.force; });
  }
  /// Within this distance lies such a share of the push.  [m]
  double within(double share) const {          // [1]
    double sofar = 0.0;                        // [N]
    for (int i = 0; i < count; ++i) {
      sofar += item[i].force;
      if (sofar >= share * sum) return item[i].away;
    }
    return item[count - 1].away;
  }
};

}  // namespace

std::optional<KnotPlace> placeOfKnot(const Model& m, const State& s) {
  if (s.strand.holeCount < 2) return std::nullopt;
  const double first = s.strand.holes[0].coordinate, last = s.strand.holes[s.strand.holeCount - 1].coordinate;   // [m]
  Pushes tail, tip;
  for (int i = 0; i < s.threadContacts.count; ++i) {
    const ThreadContact& c = s.threadContacts.contacts[i];
    if (c.partner < 0) continue;
    const auto [low, high] = std::minmax(m.strand.place[c.sample / kMostSamples + 1], m.strand.place[c.partner + 1]);   // [m] of both pieces' middles
    if (low > first || high < last) continue;
    tail.add(first - low, c.normalForce);
    tip.add(high - last, c.normalForce);
  }
  if (tail.sum <= 0.0) return std::nullopt;
  tail.sort();
  tip.sort();
  return KnotPlace{first - tail.within(kPassedOver), last + tip.within(kPassedOver), first - tail.within(1.0 - kPassedOver), last + tip.within(1.0 - kPassedOver)};
}

}  // namespace halsted
