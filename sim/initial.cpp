#include <algorithm>

#include "sim/cutting/burn.h"
#include "sim/cutting/pieces.h"
#include "sim/damage.h"
#include "sim/needling/needling_scene.h"
#include "sim/step.h"
#include "sim/suture/fresh_thread.h"
#include "sim/suture/holes.h"
#include "sim/suture/stitch_course.h"
#include "sim/tissue/tissue.h"
#include "sim/tools/load_driver.h"

namespace halsted {
namespace {

void beginCut(const Model& m, State& s) {
  const std::size_t tets = m.mesh.tets.size(), particles = m.mesh.vertices.size();
  s.tissue.heat.assign(tets, 0.0);
  s.tissue.gone.assign(tets, 0);
  s.tissue.left.assign(particles, 1.0);
  s.tissue.piece.assign(particles, 0);
  s.cut.emplace();
  s.cut->piece.assign(tets, 0);
  s.cut->bare.assign(particles, 0);
  s.cut->tie.assign(m.surface.neighbour.size(), 1);
  for (int wall = 0; wall < kCutWalls; ++wall) s.cut->edge[wall].resize(m.cut.edge[wall].size());
  s.metrics.cut.emplace();
  s.work.cut.parent.resize(particles);
  s.work.cut.label.resize(particles);
  s.work.cut.volume.resize(tets + 1);
  findPieces(m, s);
}

void beginSuture(const Model& m, State& s) {
  s.tissue = restState(m.tissue);
  if (m.join.present()) s.metrics.seam.emplace();
  s.strand = restState(m.strand, beginsWithNeedle(m) ? loadDriver(m, s.tools[kRight]) : needleOnTable());
  if (m.params.thread.knots) {
    const ThreadParams& t = m.params.thread;
    s.threadContacts = restContacts(m.strand);
    s.knot.watched = true;
    if (t.spare > 0) {
      s.stitches.emplace();
      s.supply.emplace();
      s.supply->left = t.spare;
    }
    if (t.assist == ThreadAssist::kKnot) { s.assist.emplace(); s.metrics.assistedKnots = 0; }
    s.work.knotReader = KnotReader(m.strand.nodes);
    s.work.threadContacts = prepareContactWork(m.strand, {t.friction, t.lateralModulus, t.breakingTension});
  } else {
    s.strand.comesThrough.assign(m.strand.nodes, 0);
  }
  if (std::any_of(m.params.second, m.params.second + kHands, [](const ToolParams& p) { return p.kind != ToolKind::kNone; })) s.instruments.emplace();
  if (m.params.assistant.clamps > 0) { s.clamps.emplace(); s.clamps->left = m.params.assistant.clamps; }
  s.work.tissue = prepareWork(m.tissue);
  s.work.strand = prepareWork(m.strand);
  s.work.strandBefore = s.strand;
  s.work.threadBefore = s.threadContacts;
  s.work.force.assign(m.mesh.vertices.size(), Vec3::Zero());
  s.work.change.assign(m.mesh.vertices.size(), Vec3::Zero());
  for (auto* list : {&s.work.self.cell, &s.work.self.item, &s.work.self.inside}) list->resize(m.surface.vertices.size());
  s.work.self.place.assign(3 * m.surface.vertices.size() + 4, 0.0);
  for (NearPairs& near : s.work.self.nearby) {
    for (auto* list : {&near.vertex, &near.triangle}) list->resize(NearPairs::kMost);
    near.far.resize(NearPairs::kMost);
    near.place.assign(m.surface.vertices.size(), Vec3::Zero());
  }
  s.work.self.ring.resize(m.mesh.vertices.size());
  const std::size_t boxes = (m.surface.vertices.size() + VertexBoxes::kVertices - 1) / VertexBoxes::kVertices;
  for (auto* corner : {&s.work.boxes.low, &s.work.boxes.high}) corner->assign(boxes, Vec3::Zero());
  s.work.self.give.resize(m.mesh.vertices.size());
  s.work.self.nearest.resize(m.mesh.vertices.size());
  beginDamage(m, s);
  if (m.cut.present()) beginCut(m, s);
}

void prepareSutureSnapshot(const Model& m, RenderSnapshot& r) {
  if (m.cut.present()) {
    r.exposed.assign(m.surface.triangles.size(), 0);
    r.charred.assign(m.surface.triangles.size(), 0.0);
  }
  r.tissue.resize(m.mesh.vertices.size());
  r.bruised.assign(m.mesh.vertices.size(), 0.0);
  r.thread.resize(m.strand.nodes);
  r.twist.assign(m.strand.nodes, 0.0);
  static_assert(kMostPunctures >= StrandState::kMaxHoles);
  r.punctures.resize(kMostPunctures);
  r.stitches.resize(m.params.thread.spare > 0 ? TiedStitches::kMost * kStitchPoints : 0);
}

/// Open holes: the running strand's, then those of the kept stitches as far as there is room.
void fillPunctures(const Model& m, const State& s, RenderSnapshot& r) {
  r.punctureCount = 0;
  const auto add = [&](const TissuePoint& hole) {
    if (r.punctureCount < static_cast<int>(r.punctures.size())) r.punctures[r.punctureCount++] = pointOf(m, hole, s.tissue.position);
  };
  for (int i = 0; i < s.strand.holeCount; ++i) add(placeOf(s.strand.holes[i]));
  for (int k = 0; s.stitches && k < s.stitches->count; ++k)
    for (int i = 0; i < s.stitches->stitch[k].holeCount; ++i) add(s.stitches->stitch[k].hole[i]);
}

void fillStitches(const Model& m, const State& s, RenderSnapshot& r) {
  r.stitchesDone = finishedStitches(m, s);
  r.stitchCount = s.stitches ? std::min<int>(s.stitches->count, static_cast<int>(r.stitches.size()) / kStitchPoints) : 0;
  for (int k = 0; k < r.stitchCount; ++k)
    courseOf(m, s.stitches->stitch[k], s.tissue.position, std::span<Vec3, kStitchPoints>(r.stitches.data() + k * kStitchPoints, kStitchPoints));
}

void fillCut(const Model& m, const TissueState& t, RenderSnapshot& r) {
  for (int f = 0; f < static_cast<int>(r.exposed.size()); ++f) {
    const int tet = m.surface.triangleTet[f];
    r.exposed[f] = exposed(m.surface, t.gone, f);
    r.charred[f] = t.heat[tet] / (m.tissue.restVolume[tet] * m.params.cautery.cuttingEnergy);
  }
}

void fillSutureSnapshot(const Model& m, const State& s, RenderSnapshot& r) {
  for (std::size_t i = 0; i < r.bruised.size(); ++i) r.bruised[i] = s.bruise[i][static_cast<int>(Presser::kInstrument)] / kTraumaTime;
  if (s.cut) fillCut(m, s.tissue, r);
  std::copy(s.tissue.position.begin(), s.tissue.position.end(), r.tissue.begin());
  std::copy(s.strand.position.begin(), s.strand.position.end(), r.thread.begin());
  r.needle = s.strand.needle;
  r.threadOnTable = threadOnTable(m, s);
  fillPunctures(m, s, r);
  fillStitches(m, s, r);
  r.bites = static_cast<std::uint32_t>(s.metrics.biteCount);
  r.openingArea = s.metrics.openingArea;
  r.threadTension = 0.0;
  for (double t : s.strand.tension) r.threadTension = t > r.threadTension ? t : r.threadTension;
}

}  // namespace

State initialState(const Model& m, const std::array<Pose, kHands>& start) {
  State s;
  s.random = m.params.seed;
  for (int hand = 0; hand < kHands; ++hand) s.tools[hand].device = s.tools[hand].proxy = start[hand];
  switch (m.params.model) {
    case ModelKind::kSuture: beginSuture(m, s); break;
    case ModelKind::kNeedling: beginNeedling(m, s); break;
  }
  return s;
}

void prepareSnapshot(const Model& m, RenderSnapshot& r) {
  switch (m.params.model) {
    case ModelKind::kSuture: prepareSutureSnapshot(m, r); break;
    case ModelKind::kNeedling: prepareNeedlingSnapshot(m, r); break;
  }
}

void fillSnapshot(const Model& m, const State& s, RenderSnapshot& r) {
  r.step = s.step;
  r.time = s.step * m.params.dt;
  for (int hand = 0; hand < kHands; ++hand)
    r.tools[hand] = {s.tools[hand].proxy, s.tools[hand].jaw, s.tools[hand].force, s.instruments && s.instruments->second[hand] == 1, smokes(m, s, hand)};
  r.clampCount = s.clamps ? s.clamps->count : 0;
  for (int k = 0; k < r.clampCount; ++k) {
    const StandingClamp& c = s.clamps->clamp[k];
    r.clamps[k] = {c.hand, {c.pose, c.jaw, Vec3::Zero(), c.second == 1, false}};
  }
  r.procedureStep = s.procedure.current;
  r.faults = 0;
  for (std::int32_t f : s.procedure.faults) r.faults += static_cast<std::uint32_t>(f);
  switch (m.params.model) {
    case ModelKind::kSuture: fillSutureSnapshot(m, s, r); break;
    case ModelKind::kNeedling: fillNeedlingSnapshot(m, s, r); break;
  }
}

}  // namespace halsted
