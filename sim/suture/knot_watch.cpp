#include "sim/suture/knot_watch.h"

#include <algorithm>

#include "sim/strand/tool_winding.h"
#include "sim/suture/holes.h"
#include "sim/suture/knot_place.h"
#include "sim/tools/instrument.h"

namespace halsted {
namespace {

static_assert(ThrowList::kMost == KnotState::kMostThrows, "every throw that is read has its place in the state");
constexpr double kRoundTool = 12.0;            // [1] of the jaws' radius: where the strands of a loop round a tool may cross, this far from its axis
constexpr double kLoopEnds = 4.0;              // [1] of the jaws' radius, where the paper has one pair of its coarse nodes: a turn climbs by up to this

bool due(const Model& m, const State& s) {
  const auto steps = static_cast<std::uint64_t>(kKnotInterval / m.params.dt + 0.5);
  return s.step % std::max<std::uint64_t>(1, steps) == 0;
}

bool meetsItself(const ThreadContactState& t) {
  for (int i = 0; i < t.count; ++i)
    if (t.contacts[i].partner >= 0) return true;
  return false;
}

/// Thread that lies over its own knot can hide it for a while; it cannot untie it. So what cannot be read leaves what was read last, and
/// thread that has come free of itself is read again.
void writeReading(const KnotReading& r, KnotState& k) {
  k.crossingsLeft = r.crossingsLeft;
  if (!r.complete) return;
  k.complete = true;
  k.throws = static_cast<std::int32_t>(r.throws.size());
  k.turns = {};
  k.sense = {};
  for (int i = 0; i < k.throws; ++i) {
    k.turns[i] = r.throws[i].turns;
    k.sense[i] = r.throws[i].sign;
  }
}

/// Where it lies; while nothing is felt of that, where it lay.
void writePlace(const Model& m, const State& s, KnotState& k) {
  if (k.throws == 0) k.tail = k.tip = 0.0;
  else if (const std::optional<KnotPlace> place = placeOfKnot(m, s)) {
    k.tail = place->tail;
    k.tip = place->tip;
  }
}

/// Thread wound about a tool's jaws or shaft.
std::int32_t turnsOf(const Model& m, const State& s, int hand) {
  const ToolParams& p = toolOf(m, s, hand);
  const Pose& tool = s.tools[hand].proxy;
  return woundTurns(s.strand.position, {tool.position, tool.orientation * Vec3::UnitZ(), kRoundTool * p.jawRadius, 2.0 * p.jawLength}, kLoopEnds * p.jawRadius);
}

}  // namespace

void watchKnots(const Model& m, State& s, StepOutput& out) {
  KnotState& k = s.knot;
  if (!k.watched || !due(m, s)) return;
  const int before = k.throws;
  writeReading(meetsItself(s.threadContacts) ? s.work.knotReader.read(s.strand.position) : KnotReading{{}, true, 0}, k);
  writePlace(m, s, k);
  for (int hand = 0; hand < kHands; ++hand) k.toolTurns[hand] = turnsOf(m, s, hand);
  k.breaks = 0;
  for (std::uint8_t cut : s.threadContacts.cut) k.breaks += cut;
  if (k.throws > before) pushEvent(out, {s.step, EventKind::kThrowTied, -1, k.throws, static_cast<double>(k.sense[k.throws - 1] * k.turns[k.throws - 1])});
  if (k.throws < before) pushEvent(out, {s.step, EventKind::kThrowLost, -1, k.throws, 0.0});
}

}  // namespace halsted
