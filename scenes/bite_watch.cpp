#include "scenes/bite_watch.h"

#include "sim/strand/strand.h"
#include "sim/suture/hole_sides.h"
#include "sim/suture/holes.h"

namespace halsted::scenes {
namespace {

constexpr double kPerforated = 0.5;            // [1] of the planned width: out again so soon, the needle has gone straight through
constexpr double kSlid = 0.5;                  // [1] of the way from entry to exit: so far along the wall it will not go in where it should

}  // namespace

bool entered(const State& s, std::int32_t bite) { return s.strand.holeCount > 0 && s.strand.holes[s.strand.holeCount - 1].bite >= bite; }

bool slidAway(const Scene& s) {
  const ExpertState& e = s.memory;
  if (s.action.across || entered(s.state, e.bite)) return false;
  const Vec3 entry = positionOf(s.model, s.state, e.plan.entry), exit = positionOf(s.model, s.state, e.plan.exit);
  const Vec3 tip = strandPoint(s.model.strand, s.state.strand, tipCoordinate(s.model.strand));
  return (tip - entry).dot(exit - entry) > kSlid * (exit - entry).squaredNorm();
}

const Hole* exitHole(const State& s, std::int32_t bite) {
  for (int i = s.strand.holeCount - 1; i >= 0; --i) {
    const Hole& h = s.strand.holes[i];
    if (h.bite >= bite && (h.role == static_cast<int>(HoleRole::kExit) || h.role == static_cast<int>(HoleRole::kPassed))) return &h;
  }
  return nullptr;
}

bool tipInWall(const State& s) {
  return s.strand.holeCount > 0 && s.strand.holes[s.strand.holeCount - 1].role == static_cast<int>(HoleRole::kTip);
}

int exits(const Scene& s) {
  int count = 0;
  for (int i = 0; i < s.state.strand.holeCount; ++i) {
    const Hole& h = s.state.strand.holes[i];
    count += h.bite >= s.memory.bite && (h.role == static_cast<int>(HoleRole::kExit) || h.role == static_cast<int>(HoleRole::kPassed));
  }
  return count;
}

bool astray(const Scene& s) {
  const Hole* exit = exitHole(s.state, s.memory.bite);
  if (exit == nullptr || exit == s.state.strand.holes.data()) return false;
  if (s.action.through) return exits(s) == 1 && !onMucosa(s.model, *exit);
  if (s.action.across) return exits(s) == 1 && onMucosa(s.model, *exit);        // out of the first wall on the side on which it went in
  const std::span<const Vec3> rest = s.model.mesh.vertices;
  return (holePoint(s.model, *exit, rest) - holePoint(s.model, *(exit - 1), rest)).norm() < kPerforated * s.action.width;
}

}  // namespace halsted::scenes
