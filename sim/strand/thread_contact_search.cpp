#include "sim/strand/thread_contact_search.h"

#include <algorithm>

namespace halsted {
namespace {

constexpr int kChunk = kPiecesPerChunk;

/// Bounding spheres of pieces and of chunks of pieces, and the fastest node.
void boundPieces(const StrandModel& m, const StrandState& s, ThreadContactWork& w) {
  const int pieces = m.nodes - 2;
  double fastest = 0.0;                        // [m^2/s^2]
  for (const Vec3& v : s.velocity) fastest = std::max(fastest, v.squaredNorm());
  w.fastest = std::sqrt(fastest);
  for (int p = 0; p < pieces; ++p) {
    // A piece lies in the triangle of its two ends and its middle node.
    const Vec3 centre = curvePoint(s.position, curveWeights(p, 0.5));
    const double a = (0.5 * (s.position[p] + s.position[p + 1]) - centre).squaredNorm();       // [m^2]
    const double b = (0.5 * (s.position[p + 1] + s.position[p + 2]) - centre).squaredNorm();   // [m^2]
    const double c = (s.position[p + 1] - centre).squaredNorm();                               // [m^2]
    w.pieces.set(p, centre, std::sqrt(std::max(a, std::max(b, c))));
    w.sampled[p].filled = false;
  }
  for (std::size_t chunk = 0; chunk < w.chunkCentre.size(); ++chunk) {
    const int begin = static_cast<int>(chunk) * kChunk, end = std::min(pieces, begin + kChunk);
    const Vec3 centre = w.pieces.centre((begin + end) / 2);
    double radius = 0.0;                       // [m]
    for (int p = begin; p < end; ++p) radius = std::max(radius, (w.pieces.centre(p) - centre).norm() + w.pieces.radius[p]);
    w.chunkCentre[chunk] = centre;
    w.chunkRadius[chunk] = radius;
  }
}

/// Of the middles of two pieces that are filled.  [m/s]
double relativeSpeed(const ThreadContactWork& w, int p, int q) { return (w.sampled[p].velocity - w.sampled[q].velocity).norm(); }

class Search {
 public:
  Search(const StrandModel& m, const StrandState& s, double dt, ThreadTouch& touch)
      : model_(m), state_(s), dt_(dt), work_(touch.work), cut_(touch.state.cut), reach_(2.0 * (1.0 + kWide) * m.radius) {}

  bool run() {
    const int chunks = static_cast<int>(work_.chunkCentre.size());
    for (int a = 0; a < chunks; ++a)
      for (int b = a; b < chunks; ++b) {
        const double sum = work_.chunkRadius[a] + work_.chunkRadius[b] + reach_ + 2.4 * dt_ * work_.fastest;   // [m]
        if ((work_.chunkCentre[a] - work_.chunkCentre[b]).squaredNorm() < sum * sum && !chunkPair(a, b)) return false;
      }
    return true;
  }

 private:
  bool chunkPair(int a, int b) {
    const int pieces = model_.nodes - 2;
    const int endA = std::min(pieces, kChunk * (a + 1)), endB = std::min(pieces, kChunk * (b + 1));
    const double far = reach_ + 2.4 * dt_ * work_.fastest;             // [m]
    int near[kChunk];
    for (int p = kChunk * a; p < endA; ++p) {
      if (ends(p)) continue;
      const int from = std::max(kChunk * b, work_.firstBeyond[p]);
      const int count = spheresNear(work_.pieces, from, endB, work_.pieces.centre(p), work_.pieces.radius[p] + far, near, path_);
      for (int k = 0; k < count; ++k) {
        const int q = near[k];
        if (ends(q)) continue;
        fill(p);
        fill(q);
        const double reach = reach_ + 1.2 * dt_ * relativeSpeed(work_, p, q);   // [m]
        if (!samples(p, q, reach) || !samples(q, p, reach)) return false;
      }
    }
    return true;
  }
  /// A piece that runs across a break.
  bool ends(int piece) const { return cut_[piece] || cut_[piece + 1]; }
  void fill(int p) {
    SampledPiece& piece = work_.sampled[p];
    if (piece.filled) return;
    piece.filled = true;
    piece.velocity = curvePoint(state_.velocity, curveWeights(p, 0.5));
    const int count = work_.samples[p];
    for (int k = 0; k < count; ++k) piece.points.set(k, curvePoint(state_.position, curveWeights(p, (k + 0.5) / count)));
  }
  bool samples(int own, int other, double reach) {   // [m]
    const Vec3 centre = work_.pieces.centre(other);
    const double sum = work_.pieces.radius[own] + work_.pieces.radius[other] + reach;   // [m]
    if ((work_.pieces.centre(own) - centre).squaredNorm() > sum * sum) return true;
    const int count = work_.samples[own];
    const PointRow& points = work_.sampled[own].points;
    std::array<double, PointRow::kMost> places;                        // [1]
    nearestPlaces(pieceShape(state_.position, other), points, count, {centre, work_.pieces.radius[other] + reach + kRounding}, places, path_);
    for (int k = 0; k < count; ++k) {
      const double place = places[k];                                  // [1]
      if (place < 0.0) continue;
      const double squared = (points.at(k) - curvePoint(state_.position, curveWeights(other, place))).squaredNorm();   // [m^2]
      if (squared > reach * reach) continue;
      if (work_.near.size() >= kMostNear) return false;
      work_.near.push_back({own, k, other, place, std::sqrt(squared) - 2.0 * model_.radius});
    }
    return true;
  }

  const StrandModel& model_;
  const StrandState& state_;
  double dt_;                                  // [s]
  ThreadContactWork& work_;
  const std::vector<std::uint8_t>& cut_;       // [1]
  double reach_;                               // [m] between centre lines at rest
  LanePath path_ = widestLanes();
};

}  // namespace

bool searchNear(const StrandModel& m, const StrandState& s, double dt, ThreadTouch& touch) {
  ThreadContactWork& w = touch.work;
  w.near.clear();
  boundPieces(m, s, w);
  const bool complete = Search(m, s, dt, touch).run();
  std::fill(w.allowance.begin(), w.allowance.end(), kWide * m.radius);
  for (const NearPair& pair : w.near) {
    const double half = std::max(0.5 * pair.gap, kNarrow * m.radius);   // [m]
    w.allowance[pair.piece] = std::min(w.allowance[pair.piece], half);
    w.allowance[pair.partner] = std::min(w.allowance[pair.partner], half);
  }
  return complete;
}

bool mayTouch(const NearPair& pair, double dt, const ThreadContactWork& w) {
  return pair.gap < 1.01 * (w.allowance[pair.piece] + w.allowance[pair.partner]) + 1.2 * dt * relativeSpeed(w, pair.piece, pair.partner);
}

}  // namespace halsted
