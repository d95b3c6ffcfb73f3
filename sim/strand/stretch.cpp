#include "sim/strand/stretch.h"

#include <array>

#include "sim/strand/eliminate_row.h"

namespace halsted {
namespace {

constexpr int kStride = BandedMatrix::kStride, kBorder = StretchBand::kBorder;

HALSTED_INLINE double* rowOf(const StretchBand& b, int j) { return b.rows + static_cast<std::size_t>(j) * kStride; }       // [N/m]
HALSTED_INLINE double* borderOf(const StretchBand& b, int j) { return b.border + static_cast<std::size_t>(j) * kBorder; }   // [N/m]

HALSTED_INLINE bool eliminateBody(const StretchBand& b, const Stretch& s, double* x) {   // [N]
  for (int j = 3 * s.first; j < 3 * (s.last + 1); ++j) {
    double* row = rowOf(b, j);
    if (!(row[0] > 0.0)) return false;
    const double inverse = 1.0 / row[0];       // [m/N]
    if (s.bordered()) eliminateColumn<kBorder>(row, borderOf(b, j), inverse, x[j], x + j);
    else eliminateColumn<0>(row, nullptr, inverse, x[j], x + j);
    row[0] = inverse;
  }
  return true;
}

/// The corner of the two blocks, and behind its six columns the right-hand side's, are kept apart while they are summed: eight a row.
template <typename L> HALSTED_INLINE void reduceBody(const StretchBand& b, const Stretch& s, double* x) {   // [N]
  const int begin = 3 * (s.first - 2);
  std::array<std::array<double, 8>, kBorder> corner{};   // [N/m], [N]
  for (int a = 0; a < kBorder; ++a) {
    for (int c = a; c < kBorder; ++c) corner[a][c] = rowOf(b, begin + a)[c - a];
    corner[a][kBorder] = x[begin + a];
  }
  L near[kBorder], far[kBorder];
  for (int a = 0; a < kBorder; ++a) {
    near[a] = loadLanes<L>(corner[a].data());
    far[a] = loadLanes<L>(corner[a].data() + 4);
  }
  for (int j = 3 * s.first; j < 3 * (s.last + 1); ++j) {
    const double* border = borderOf(b, j);
    const double inverse = rowOf(b, j)[0];     // [m/N]
    const L first = loadLanes<L>(border), second = loadLanes<L>(std::array<double, 4>{border[4], border[5], x[j], 0.0}.data());
    for (int a = 0; a < kBorder; ++a) {
      const double factor = border[a] * inverse;   // [1]
      near[a] = near[a] - factor * first;
      far[a] = far[a] - factor * second;
    }
  }
  for (int a = 0; a < kBorder; ++a) {
    storeLanes(corner[a].data(), near[a]);
    storeLanes(corner[a].data() + 4, far[a]);
    for (int c = a; c < kBorder; ++c) rowOf(b, begin + a)[c - a] = corner[a][c];
    x[begin + a] = corner[a][kBorder];
  }
}

#define HALSTED_WIDE __attribute__((target("avx2")))
HALSTED_WIDE bool eliminateWide(const StretchBand& b, const Stretch& s, double* x) { return eliminateBody(b, s, x); }
HALSTED_WIDE void reduceWide(const StretchBand& b, const Stretch& s, double* x) { reduceBody<Lanes4>(b, s, x); }
#undef HALSTED_WIDE

}  // namespace

bool eliminate(const StretchBand& b, const Stretch& s, double* x, LanePath path) {   // [N]
  return path == LanePath::kWide ? eliminateWide(b, s, x) : eliminateBody(b, s, x);
}

void reduceBorder(const StretchBand& b, const Stretch& s, double* x, LanePath path) {   // [N]
  if (!s.bordered()) return;
  if (path == LanePath::kWide) reduceWide(b, s, x);
  else reduceBody<Serial4>(b, s, x);
}

/// A chain of dependent differences: what the next row waits for stays in a register, and comes last.
void substitute(const StretchBand& b, const Stretch& s, double* x) {   // [N] then [m]
  const int before = 3 * (s.first - 2), end = 3 * (s.last + 1);
  double last = x[end];                        // [m]
  for (int j = end - 1; j >= 3 * s.first; --j) {
    const double *row = rowOf(b, j), *border = borderOf(b, j);
    double sum = x[j];                         // [N]
    if (s.bordered())
      for (int c = 0; c < kBorder; ++c) sum -= border[c] * x[before + c];
    x[j] = last = lessRow(row, x + j, last, sum) * row[0];
  }
}

}  // namespace halsted
