#include "sim/suture/knot_place.h"

#include <algorithm>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted {
namespace {

constexpr double kPassedOver = 0.05;           // [1] of the push
constexpr double kNear = 3.0;                  // [1] diameters of the thread

struct Push { double away = 0.0, force = 0.0; Vec3 at = Vec3::Zero(); };   // [m] of thread from the hole, [N], [m]

struct Pushes {
  std::array<Push, ThreadContactState::kMaxContacts> item;
  int count = 0;
  double sum = 0.0;                            // [N]

  void add(const Push& push) {
    item[count++] = push;
    sum += push.force;
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
  /// Where the knot begins: what is passed over belongs to it where it lies against the rest, as a turn does under throws that are drawn much tighter.  [m]
  double begins(double near) const {           // [m]
    const double from = within(kPassedOver), to = within(1.0 - kPassedOver);   // [m]
    for (int i = 0; i < count && item[i].away < from; ++i)
      for (int j = i + 1; j < count && item[j].away <= to; ++j)
        if (item[j].away >= from && (item[j].at - item[i].at).squaredNorm() < near * near) return item[i].away;
    return from;
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
    const auto [low, high] = std::minmax({c.sample / kMostSamples + 1, c.partner + 1});   // in the middle of both pieces
    if (m.strand.place[low] > first || m.strand.place[high] < last) continue;
    tail.add({first - m.strand.place[low], c.normalForce, s.strand.position[low]});
    tip.add({m.strand.place[high] - last, c.normalForce, s.strand.position[high]});
  }
  if (tail.sum <= 0.0) return std::nullopt;
  tail.sort();
  tip.sort();
  const double near = kNear * 2.0 * m.params.thread.radius;      // [m]
  return KnotPlace{first - tail.begins(near), last + tip.begins(near), first - tail.within(1.0 - kPassedOver), last + tip.within(1.0 - kPassedOver)};
}

}  // namespace halsted
