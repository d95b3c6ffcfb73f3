/// What the whole seam looks like: see the header.
#include "sim/whole_seam.h"

#include <algorithm>

#include "sim/join_stretch.h"
#include "sim/portable_math.h"
#include "sim/state.h"
#include "sim/suture/fresh_thread.h"
#include "sim/suture/holes.h"
#include "sim/suture/tied_loop.h"
#include "sim/tools/load_driver.h"

namespace halsted {
namespace {

constexpr double kLoose = 3e-3;                // [m] a loop that hangs farther does not hold its walls

std::vector<TissuePoint> holesOf(const State& s, int stitch) {   // one past the kept ones: the running strand
  const int kept = s.stitches ? s.stitches->count : 0;
  std::vector<TissuePoint> holes;
  if (stitch < kept) {
    const TiedStitch& t = s.stitches->stitch[stitch];
    holes.assign(t.hole.begin(), t.hole.begin() + t.holeCount);
  } else {
    for (int i = 0; i < s.strand.holeCount; ++i) holes.push_back(placeOf(s.strand.holes[i]));
  }
  return holes;
}

int stitchCount(const State& s) { return (s.stitches ? s.stitches->count : 0) + (s.strand.holeCount > 1 ? 1 : 0); }

/// All round but the widest run of columns without a stitch.
SewnStretch sewnByAll(const Model& m, const State& s, int bowel) {
  const int around = static_cast<int>(m.bowels.rim[bowel].size());
  std::vector<bool> sewn(static_cast<std::size_t>(around));
  for (int k = 0; k < stitchCount(s); ++k)
    for (const TissuePoint& hole : holesOf(s, k))
      if (m.bowels.of[m.tissue.tets[hole.tet][0]] == bowel) sewn[columnNear(m, bowel, pointOf(m, hole, m.mesh.vertices))] = true;
  SewnStretch bare;
  for (int i = 0; i < around; ++i) {
    if (!sewn[i]) continue;
    int run = 0;
    while (run + 1 < around && !sewn[(i + 1 + run) % around]) ++run;
    if (run >= bare.count) bare = {(i + 1) % around, run};
  }
  const bool any = std::find(sewn.begin(), sewn.end(), true) != sewn.end();
  return any ? SewnStretch{(bare.first + bare.count) % around, around - bare.count} : SewnStretch{};
}

/// Where each stitch crosses the seam at rest, in their order round the left rim.  [m]
std::vector<Vec3> crossingsInOrder(const Model& m, const State& s) {
  std::vector<std::pair<int, Vec3>> found;
  for (int k = 0; k < stitchCount(s); ++k) {
    Vec3 sum[2] = {Vec3::Zero(), Vec3::Zero()};   // [m]
    int count[2] = {0, 0};
    for (const TissuePoint& hole : holesOf(s, k)) {
      const int bowel = m.bowels.of[m.tissue.tets[hole.tet][0]];
      sum[bowel] += pointOf(m, hole, m.mesh.vertices);
      ++count[bowel];
    }
    if (count[0] == 0 || count[1] == 0) continue;
    const Vec3 left = sum[0] / count[0];       // [m]
    found.emplace_back(columnNear(m, 0, left), 0.5 * (left + sum[1] / count[1]));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Vec3> places;                    // [m]
  for (const auto& [column, place] : found) places.push_back(place);
  return places;
}

/// From stitch to stitch round the ring, without the widest: there the ring is open.  [m]
std::vector<double> spacings(const std::vector<Vec3>& places) {   // [m]
  std::vector<double> apart;                   // [m]
  for (std::size_t i = 0; i < places.size() && places.size() > 1; ++i) apart.push_back((places[(i + 1) % places.size()] - places[i]).norm());
  std::sort(apart.begin(), apart.end());
  if (!apart.empty()) apart.pop_back();
  return apart;
}

/// How far each loop hangs, of the stitches kept and of the running strand's; nought where it pulls.  [m]
std::vector<double> slacks(const Model& m, const State& s) {
  std::vector<double> slack;                   // [m]
  for (int k = 0; k < s.stitches->count; ++k) {
    const TiedStitch& stitch = s.stitches->stitch[k];
    slack.push_back(stitch.tension > 0.0 ? 0.0 : std::max(0.0, stitch.length - loopLength(m, stitch, s.tissue.position)));
  }
  if (const std::optional<TiedLoop> loop = finishedLoop(m, s)) slack.push_back(loopSlack(m, s, *loop));
  return slack;
}

}  // namespace

JoinMetrics measureWholeSeam(const Model& m, const State& s) {
  JoinMetrics join = measureJoin(m, s);
  if (!s.stitches || s.stitches->count == 0) return join;
  join.rimGap = join.wallGap = join.inversion = 0.0;
  join.crossings = static_cast<std::int32_t>(crossingsInOrder(m, s).size());
  const std::array<SewnStretch, 2> sewn{sewnByAll(m, s, 0), sewnByAll(m, s, 1)};
  for (int bowel = 0; bowel < 2; ++bowel) measureStretch(m, s, bowel, sewn[bowel], join);
  const int columns = sewn[0].count + sewn[1].count;
  join.inversion /= std::max(1, columns);
  join.sewnShare = static_cast<double>(columns) / static_cast<double>(m.join.columns[0].size() + m.join.columns[1].size());
  return join;
}

std::vector<std::pair<std::string, double>> summariseStitches(const Model& m, const State& s) {
  if (!s.stitches || !m.join.present()) return {};
  const JoinMetrics seam = measureWholeSeam(m, s);
  const std::vector<double> apart = spacings(crossingsInOrder(m, s));   // [m]
  const std::vector<double> slack = slacks(m, s);                 // [m]
  double sum = 0.0, pull = 0.0;                // [m], [N]
  for (double d : apart) sum += d;
  for (int k = 0; k < s.stitches->count; ++k) pull = std::max(pull, s.stitches->stitch[k].tension);
  return {{"stitches", finishedStitches(m, s)},
          {"stitches_torn", s.stitches->torn},
          {"threads_used", (beginsWithNeedle(m) ? 1.0 : 0.0) + s.supply->handed},
          {"stitch_spacing_mean_m", apart.empty() ? 0.0 : sum / static_cast<double>(apart.size())},
          {"stitch_spacing_min_m", apart.empty() ? 0.0 : apart.front()},
          {"stitch_spacing_max_m", apart.empty() ? 0.0 : apart.back()},
          {"stitch_tension_max_n", pull},
          {"stitch_slack_max_m", slack.empty() ? 0.0 : *std::max_element(slack.begin(), slack.end())},
          {"stitches_loose", static_cast<double>(std::count_if(slack.begin(), slack.end(), [](double hangs) { return hangs > kLoose; }))},
          {"seam_wall_gap_m", seam.wallGap},
          {"seam_inversion_deg", 180.0 / kPi * arcSine(std::clamp(seam.inversion, -1.0, 1.0))},
          {"seam_sewn_share_1", seam.sewnShare}};
}

}  // namespace halsted
