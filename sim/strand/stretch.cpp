#include "sim/strand/stretch.h"

#include "sim/strand/eliminate_row.h"

namespace halsted {
namespace {

constexpr int kHalf = BandedMatrix::kHalf, kStride = BandedMatrix::kStride, kBorder = StretchBand::kBorder;

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

/// The corner of the two blocks is kept apart while it is summed.
HALSTED_INLINE void reduceBody(const StretchBand& b, const Stretch& s, double* x) {   // [N]
  const int begin = 3 * (s.first - 2);
  double corner[kBorder][kBorder], rhs[kBorder];   // [N/m], [N]
  for (int a = 0; a < kBorder; ++a) {
    rhs[a] = x[begin + a];
    for (int c = a; c < kBorder; ++c) corner[a][c] = rowOf(b, begin + a)[c - a];
  }
  for (int j = 3 * s.first; j < 3 * (s.last + 1); ++j) {
    const double* border = borderOf(b, j);
    const double inverse = rowOf(b, j)[0];     // [m/N]
    for (int a = 0; a < kBorder; ++a) {
      const double factor = border[a] * inverse;   // [1]
      rhs[a] -= factor * x[j];
      for (int c = a; c < kBorder; ++c) corner[a][c] -= factor * border[c];
    }
  }
  for (int a = 0; a < kBorder; ++a) {
    x[begin + a] = rhs[a];
    for (int c = a; c < kBorder; ++c) rowOf(b, begin + a)[c - a] = corner[a][c];
  }
}

template <typename L> HALSTED_INLINE void forwardBody(const StretchBand& b, const Stretch& s, double* x) {   // [N]
  double* before = x + 12 * (s.first - 2);
  for (int j = 3 * s.first; j < 3 * (s.last + 1); ++j) {
    const double *row = rowOf(b, j), *border = borderOf(b, j);
    const L scaled = loadLanes<L>(x + 4 * j) * row[0];
    const int reach = reachOf(row, kHalf);
    for (int i = 1; i <= reach; ++i) storeLanes(x + 4 * (j + i), loadLanes<L>(x + 4 * (j + i)) - row[i] * scaled);
    if (!s.bordered()) continue;
    for (int c = 0; c < kBorder; ++c) storeLanes(before + 4 * c, loadLanes<L>(before + 4 * c) - border[c] * scaled);
  }
}

template <typename L> HALSTED_INLINE void substituteBody(const StretchBand& b, const Stretch& s, double* x) {   // [N] then [m]
  const double* before = x + 12 * (s.first - 2);
  for (int j = 3 * (s.last + 1) - 1; j >= 3 * s.first; --j) {
    const double *row = rowOf(b, j), *border = borderOf(b, j);
    L sum = lessRow(row, x + 4 * j, loadLanes<L>(x + 4 * j));
    if (s.bordered())
      for (int c = 0; c < kBorder; ++c) sum = sum - border[c] * loadLanes<L>(before + 4 * c);
    storeLanes(x + 4 * j, sum * row[0]);
  }
}

#define HALSTED_WIDE __attribute__((target("avx2")))
HALSTED_WIDE bool eliminateWide(const StretchBand& b, const Stretch& s, double* x) { return eliminateBody(b, s, x); }
HALSTED_WIDE void reduceWide(const StretchBand& b, const Stretch& s, double* x) { reduceBody(b, s, x); }
HALSTED_WIDE void forwardWide(const StretchBand& b, const Stretch& s, double* x) { forwardBody<Lanes4>(b, s, x); }
HALSTED_WIDE void substituteWide(const StretchBand& b, const Stretch& s, double* x) { substituteBody<Lanes4>(b, s, x); }
#undef HALSTED_WIDE

}  // namespace

bool eliminate(const StretchBand& b, const Stretch& s, double* x, LanePath path) {   // [N]
  return path == LanePath::kWide ? eliminateWide(b, s, x) : eliminateBody(b, s, x);
}

void reduceBorder(const StretchBand& b, const Stretch& s, double* x, LanePath path) {   // [N]
  if (!s.bordered()) return;
  if (path == LanePath::kWide) reduceWide(b, s, x);
  else reduceBody(b, s, x);
}

void substitute(const StretchBand& b, const Stretch& s, double* x) {   // [N] then [m]
  for (int j = 3 * (s.last + 1) - 1; j >= 3 * s.first; --j) {
    const double *row = rowOf(b, j), *border = borderOf(b, j);
    double sum = lessRow(row, x + j, x[j]);    // [N]
    if (s.bordered())
      for (int c = 0; c < kBorder; ++c) sum -= border[c] * x[3 * (s.first - 2) + c];
    x[j] = sum * row[0];
  }
}

void forwardFour(const StretchBand& b, const Stretch& s, double* x, LanePath path) {   // [N]
  if (path == LanePath::kWide) forwardWide(b, s, x);
  else forwardBody<Serial4>(b, s, x);
}

void substituteFour(const StretchBand& b, const Stretch& s, double* x, LanePath path) {   // [N] then [m]
  if (path == LanePath::kWide) substituteWide(b, s, x);
  else substituteBody<Serial4>(b, s, x);
}

}  // namespace halsted
