#include "sim/fits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

#include "sim/fields.h"
#include "sim/model.h"
#include "sim/suture/strand_sample.h"
#include "sim/tools/tool_shape.h"

namespace halsted {
namespace {

constexpr std::int64_t kAnyNumber = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kMostCounted = 1 << 30;   // of what only counts up: far from where it would overflow

/// Of the integers in a field, by its path without indices.
struct Range {
  const char* field;
  std::int64_t low, high;                      // a low of -1: none, where an array goes on behind its count
};
using Ranges = std::vector<Range>;

/// Of so many; where there are none a zero that nothing reads may stand.
std::int64_t lastOf(std::size_t size) { return std::max<std::int64_t>(static_cast<std::int64_t>(size) - 1, 0); }

void add(Ranges& ranges, std::initializer_list<Range> more) {
  for (const Range& r : more) ranges.push_back(r);
}

void addTissue(const Model& m, Ranges& r) {
  const std::int64_t vertex = lastOf(m.mesh.vertices.size()), triangle = lastOf(m.surface.triangles.size()), tets = static_cast<std::int64_t>(m.mesh.tets.size());
  add(r, {
      {"tissue.pairCount", 0, tets > 0 ? TissueState::kMaxPairs : 0}, {"tissue.droppedPairs", 0, kMostCounted},
      {"tissue.pairVertex", -1, vertex}, {"tissue.pairTriangle", -1, triangle},
      {"tissue.gone", 0, static_cast<std::int64_t>(Gone::kTaken)}, {"tissue.piece", -1, tets},
      {"cut.piece", -1, tets}, {"cut.bare", 0, 1}, {"cut.tie", 0, 1}, {"cut.edge", 0, vertex}, {"cut.pieces", 0, tets}, {"cut.goneTets", 0, tets},
  });
}

void addStrand(const Model& m, Ranges& r) {
  const std::int64_t vertex = lastOf(m.mesh.vertices.size()), tet = lastOf(m.mesh.tets.size()), nodes = m.strand.nodes;
  const std::int64_t samples = sampleCount(m.strand) + nodes, pieces = std::max<std::int64_t>(nodes - 2, 0);
  add(r, {
      {"strand.nearVertex", 0, vertex}, {"strand.otherVertex", -1, vertex}, {"strand.comesThrough", 0, 1},
      {"strand.holeCount", 0, StrandState::kMaxHoles}, {"strand.holes.tet", 0, tet}, {"strand.holes.slip", -1, 1},
      {"strand.holes.bite", -1, kMostCounted}, {"strand.holes.role", 0, static_cast<std::int64_t>(HoleRole::kTip)}, {"strand.bitesBegun", 0, kMostCounted},
      {"strand.contactCount", 0, StrandState::kMaxContacts}, {"strand.contacts.sample", -1, samples - 1},
      {"strand.contacts.feature", -1, lastOf(m.surface.triangles.size()) + kSolids},
      {"threadContacts.count", 0, ThreadContactState::kMaxContacts}, {"threadContacts.dropped", 0, kMostCounted}, {"threadContacts.cut", 0, 1},
      {"threadContacts.contacts.sample", 0, kMostSamples * pieces - 1}, {"threadContacts.contacts.partner", -kSolids, pieces - 1},
      {"knot.throws", 0, KnotState::kMostThrows}, {"knot.turns", -kMostCounted, kMostCounted}, {"knot.sense", -1, 1}, {"knot.crossingsLeft", 0, kMostCounted},
      {"knot.toolTurns", -kMostCounted, kMostCounted}, {"knot.breaks", 0, kMostCounted}, {"knot.cuts", 0, kMostCounted}, {"assist.locks", 0, kMostCounted},
  });
}

void addStitches(const Model& m, Ranges& r) {
  const std::int64_t triangle = lastOf(m.surface.triangles.size());
  add(r, {
      {"stitches.count", 0, TiedStitches::kMost}, {"stitches.torn", 0, kMostCounted}, {"stitches.stitch.holeCount", 2, TiedStitch::kMostHoles},
      {"stitches.stitch.hole.tet", -1, lastOf(m.mesh.tets.size())}, {"stitches.stitch.tailLeg.triangle", -1, triangle}, {"stitches.stitch.tipLeg.triangle", -1, triangle},
      {"supply.left", 0, kMostCounted}, {"supply.handed", 0, kMostCounted}, {"supply.refusal", 0, static_cast<std::int64_t>(ThreadRefusal::kNoDriver)},
      {"supply.bitesBefore", 0, kMostCounted}, {"supply.fullThicknessBefore", 0, kMostCounted}, {"supply.tearsBefore", 0, kMostCounted},
  });
}

void addTools(const Model& m, Ranges& r) {
  const std::int64_t triangle = lastOf(m.surface.triangles.size());
  add(r, {
      {"tools.grasp.count", 0, TissueGrasp::kMost}, {"tools.grasp.triangle", -1, triangle},
      {"tools.contactCount", 0, ToolState::kMaxContacts}, {"tools.contactTriangle", -1, triangle},
      {"tools.nearCount", 0, ToolState::kMaxNear}, {"tools.nearTriangle", -1, triangle},
      {"instruments.second", 0, 1}, {"instruments.refusal", 0, static_cast<std::int64_t>(InstrumentRefusal::kInTheWay)},
      {"clamps.clamp.hand", 0, kHands - 1}, {"clamps.clamp.second", 0, 1}, {"clamps.clamp.grasp.count", 0, TissueGrasp::kMost},
      {"clamps.clamp.grasp.triangle", -1, triangle}, {"clamps.count", 0, kMostClamps}, {"clamps.left", 0, kMostCounted},
      {"clamps.refusal", 0, static_cast<std::int64_t>(ClampRefusal::kNoneLeft)},
  });
}

void addCounts(const Model& m, Ranges& r) {
  add(r, {
      {"step", 0, kAnyNumber}, {"random", 0, kAnyNumber}, {"needling.step", 0, kAnyNumber}, {"needling.layers.phase", 0, LayerPhase::kPunctured},
      {"procedure.current", 0, static_cast<std::int64_t>(m.procedure.size())}, {"procedure.faults", 0, kMostCounted}, {"metrics.seam.lastBowel", 0, 1},
  });
  for (const char* field : {"metrics.biteCount", "metrics.acrossOpening", "metrics.tears", "metrics.perforations", "metrics.assistedKnots", "metrics.seam.join.crossings",
                            "metrics.seam.fullThickness", "metrics.cut.burnt", "metrics.cut.freePieces", "metrics.cut.taken", "metrics.cut.crumbs"})
    r.push_back({field, 0, kMostCounted});
  for (const char* field : {"metrics.needling.lifts.direction", "metrics.needling.twirls.direction"}) r.push_back({field, -1, 1});
  for (const char* field : {"metrics.needling.lifts.count", "metrics.needling.lifts.counted", "metrics.needling.lifts.troughs", "metrics.needling.twirls.count",
                            "metrics.needling.twirls.counted", "metrics.needling.twirls.troughs"})
    r.push_back({field, 0, kMostCounted});
}

Ranges rangesOf(const Model& m) {
  Ranges ranges;
  addTissue(m, ranges);
  addStrand(m, ranges);
  addStitches(m, ranges);
  addTools(m, ranges);
  addCounts(m, ranges);
  return ranges;
}

std::string withoutIndices(const std::string& path) {
  std::string out;
  bool index = false;
  for (char c : path) {
    index = index || c == '[';
    if (!index) out += c;
    index = index && c != ']';
  }
  return out;
}

/// Every number of the list; an integer whose field has no range is refused, so that a new one is not forgotten.
struct Check {
  const Ranges& ranges;
  std::string& error;

  template <class T> void leaf(const FieldPath& path, const T* data, std::size_t count, int) {
    if (!error.empty()) return;
    std::size_t bad = count;
    if constexpr (std::is_same_v<T, double>) bad = static_cast<std::size_t>(std::find_if_not(data, data + count, [](T x) { return std::isfinite(x); }) - data);
    else if constexpr (!std::is_same_v<T, bool>) bad = outOfRange(path, data, count);
    if (bad == count) return;
    error = path.text();
    if (count > 1) error.append("[").append(std::to_string(bad)).append("]");
    error.append(": ").append(std::to_string(data[bad])).append(" cannot be");
  }
  void size(const FieldPath&, std::size_t) {}

 private:
  template <class T> std::size_t outOfRange(const FieldPath& path, const T* data, std::size_t count) const {
    const std::string field = withoutIndices(path.text());
    const auto range = std::find_if(ranges.begin(), ranges.end(), [&](const Range& r) { return field == r.field; });
    if (range == ranges.end()) return 0;
    if (range->high == kAnyNumber) return count;
    return static_cast<std::size_t>(std::find_if(data, data + count, [&](T x) {
      return static_cast<std::int64_t>(x) < range->low || static_cast<std::int64_t>(x) > range->high;
    }) - data);
  }
};

/// Of the first `count`, one that names nothing.
template <class Items, class Name> bool lacks(const Items& items, int count, Name name) {
  return std::any_of(items.begin(), items.begin() + count, [&](const auto& item) { return name(item) < 0; });
}
bool lacks(std::span<const std::int32_t> indices, int count) {
  return lacks(indices, count, [](std::int32_t i) { return i; });
}

/// Behind a count an index may be -1; what the count includes must be there.
const char* missing(const State& s) {
  if (lacks(s.tissue.pairVertex, s.tissue.pairCount) || lacks(s.tissue.pairTriangle, s.tissue.pairCount)) return "tissue.pairCount";
  if (lacks(s.strand.contacts, s.strand.contactCount, [](const StrandContact& c) { return std::min(c.sample, c.feature); })) return "strand.contactCount";
  for (const ToolState& t : s.tools) {
    if (lacks(t.contactTriangle, t.contactCount)) return "tools.contactCount";
    if (lacks(t.nearTriangle, t.nearCount)) return "tools.nearCount";
    if (lacks(t.grasp.triangle, t.grasp.count)) return "tools.grasp.count";
  }
  for (int k = 0; s.clamps && k < s.clamps->count; ++k)
    if (lacks(s.clamps->clamp[k].grasp.triangle, s.clamps->clamp[k].grasp.count)) return "clamps.clamp.grasp.count";
  for (int k = 0; s.stitches && k < s.stitches->count; ++k)
    if (lacks(s.stitches->stitch[k].hole, s.stitches->stitch[k].holeCount, [](const TissuePoint& p) { return p.tet; })) return "stitches.stitch.holeCount";
  return nullptr;
}

}  // namespace

bool fits(const Model& m, const State& s, std::string& error) {
  error.clear();
  const Ranges ranges = rangesOf(m);
  Check check{ranges, error};
  visitFields(const_cast<State&>(s), check);   // it only reads
  if (!error.empty()) return false;
  if (const char* field = missing(s)) error = std::string(field) + ": counts what is not there";
  return error.empty();
}

}  // namespace halsted
