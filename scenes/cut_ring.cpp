#include "scenes/cut_ring.h"

#include <cmath>

namespace halsted::scenes {
namespace {

constexpr int kWide = 2;                       // columns to either side that say which way the wall faces

/// The two vertices of a column next to `fromLine`, on the wall's side that the pen comes to.
RingColumn columnAt(const Model& m, int wall, double turn, double fromLine) {   // [1], [m]
  constexpr double kSame = 1e-6;               // [1] of a turn
  const double side = wall == 0 ? 1.0 : 0.0;   // [1] mucosa or serosa
  int below = -1, above = -1;
  const auto& uv = m.mesh.uv;
  for (int v = 0; v < static_cast<int>(uv.size()); ++v) {
    if (m.bowels.of[v] != wall || m.bowels.wallDepth[v] != side || std::fabs(uv[v].x() - turn) > kSame) continue;
    if (uv[v].y() >= fromLine && (below < 0 || uv[v].y() < uv[below].y())) below = v;
    if (uv[v].y() < fromLine && (above < 0 || uv[v].y() > uv[above].y())) above = v;
  }
  if (below < 0 || above < 0) return {-1, -1, 0.0};
  return {below, above, (uv[below].y() - fromLine) / (uv[below].y() - uv[above].y())};
}

Vec3 pointAt(const CutRing& ring, const State& s, int column) {           // [m]
  const int around = static_cast<int>(ring.column.size());
  const RingColumn& c = ring.column[static_cast<std::size_t>((column % around + around) % around)];
  return s.tissue.position[c.below] + c.share * (s.tissue.position[c.above] - s.tissue.position[c.below]);
}

/// From the base's edge to the specimen's, over a few columns: one alone turns with every lump.
Vec3 upAt(const CutRing& ring, const State& s, int column) {              // [m]
  const int around = static_cast<int>(ring.column.size());
  Vec3 sum = Vec3::Zero();
  for (int i = -kWide; i <= kWide; ++i) {
    const RingColumn& c = ring.column[static_cast<std::size_t>(((column + i) % around + around) % around)];
    sum += s.tissue.position[c.above] - s.tissue.position[c.below];
  }
  return sum;
}

/// Between the mean of its corners on the base's edge and that of those on the specimen's: a cut gapes, and its last strands are stretched.
Vec3 middleOf(const Model& m, const State& s, int tet) {                   // [m]
  const auto& corners = m.tissue.tets[static_cast<std::size_t>(tet)];
  double low = 1e300, high = -1e300;           // [m] from the line
  for (int v : corners) {
    low = std::fmin(low, m.mesh.uv[static_cast<std::size_t>(v)].y());
    high = std::fmax(high, m.mesh.uv[static_cast<std::size_t>(v)].y());
  }
  std::array<Vec3, 2> sum{Vec3::Zero(), Vec3::Zero()};                    // [m]
  std::array<int, 2> count{};
  for (int v : corners) {
    const std::size_t side = m.mesh.uv[static_cast<std::size_t>(v)].y() > 0.5 * (low + high) ? 0 : 1;
    sum[side] += s.tissue.position[static_cast<std::size_t>(v)];
    ++count[side];
  }
  return 0.5 * (sum[0] / count[0] + sum[1] / count[1]);
}

}  // namespace

CutRing ringOn(const Model& m, int wall, double fromLine) {
  constexpr double kSameRow = 1e-6;            // [m]
  CutRing ring;
  ring.wall = wall;
  int columns = 0;
  double nearest = 1e300;                      // [m] from the circle to the middle of a row of tets
  for (const CutMark& mark : m.mesh.cutLine) {
    if (mark.wall != wall) continue;
    columns = mark.bin >= columns ? mark.bin + 1 : columns;
    nearest = std::fmin(nearest, std::fabs(mark.fromLine + fromLine));
  }
  ring.cell.resize(static_cast<std::size_t>(columns));
  for (std::size_t t = 0; t < m.mesh.cutLine.size(); ++t) {
    const CutMark& mark = m.mesh.cutLine[t];
    if (mark.wall == wall && std::fabs(mark.fromLine + fromLine) < nearest + kSameRow) ring.cell[static_cast<std::size_t>(mark.bin)].push_back(static_cast<int>(t));
  }
  for (int i = 0; i < columns; ++i) {
    const RingColumn c = columnAt(m, wall, static_cast<double>(i) / columns, fromLine);
    if (c.below < 0) return {};
    ring.column.push_back(c);
  }
  return ring;
}

RingPlace placeOnRing(const CutRing& ring, const State& s, double columns) {
  const int first = static_cast<int>(std::floor(columns));
  const double share = columns - first;        // [1]
  RingPlace place;
  place.point = (1.0 - share) * pointAt(ring, s, first) + share * pointAt(ring, s, first + 1);
  const auto alongAt = [&](int column) { return Vec3(pointAt(ring, s, column + kWide) - pointAt(ring, s, column - kWide)); };   // [m]
  const Vec3 along = (1.0 - share) * alongAt(first) + share * alongAt(first + 1);
  place.out = along.cross((1.0 - share) * upAt(ring, s, first) + share * upAt(ring, s, first + 1)).normalized();
  return place;
}

Vec3 centreOf(const CutRing& ring, const State& s) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < static_cast<int>(ring.column.size()); ++i) sum += pointAt(ring, s, i);
  return sum / static_cast<double>(ring.column.size());
}

bool bridgeAt(const CutRing& ring, const Model& m, const State& s, int column, Bridge& bridge) {
  const int around = static_cast<int>(ring.column.size());
  const Vec3& tip = s.tools[kRight].proxy.position;
  double least = 1e300;                        // [m^2]
  for (int t : ring.cell[static_cast<std::size_t>((column % around + around) % around)]) {
    if (s.tissue.gone[static_cast<std::size_t>(t)]) continue;
    const Vec3 middle = middleOf(m, s, t);
    const double d2 = (middle - tip).squaredNorm();
    if (d2 < least) { least = d2; bridge.middle = middle; }
  }
  return least < 1e300;
}

}  // namespace halsted::scenes
