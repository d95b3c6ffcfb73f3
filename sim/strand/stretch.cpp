#include "sim/strand/stretch.h"

#include <algorithm>
#include <array>

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

/// What the columns before column j have left of it, in their order; `scaled` holds these times their pivots, by place in a ring.
template <typename L, int Ring> HALSTED_INLINE L lessColumns(const StretchBand& b, int from, int to, int j, const L* scaled, L value) {   // [N]
  for (int k = std::max(from, j - BandedMatrix::kBending); k < std::min(to, j); ++k) value = value - rowOf(b, k)[j - k] * scaled[static_cast<unsigned>(k) % Ring];
  return value;
}
/// The same where there are as many as there can be, and the last of them in a register: it is what the next one waits for.
template <typename L, int Ring> HALSTED_INLINE L lessColumns(const StretchBand& b, int j, const L* scaled, L last, L value) {   // [N]
  for (int i = BandedMatrix::kBending; i > 1; --i) value = value - rowOf(b, j - i)[i] * scaled[static_cast<unsigned>(j - i) % Ring];
  return value - rowOf(b, j - 1)[1] * last;
}

template <typename L> HALSTED_INLINE void forwardBody(const StretchBand& b, const Stretch& s, double* x) {   // [N]
  constexpr int kNear = BandedMatrix::kBending, kRing = 16;
  const int begin = 3 * s.first, end = 3 * (s.last + 1);
  double* before = x + 4 * (begin - kBorder);
  L scaled[kRing], last = zeroLanes<L>(), taken[kBorder];
  for (int c = 0; c < kBorder && s.bordered(); ++c) taken[c] = loadLanes<L>(before + 4 * c);
  for (int j = begin; j < end; ++j) {
    const double *row = rowOf(b, j), *border = borderOf(b, j);
    const L own = loadLanes<L>(x + 4 * j);
    const L value = j < begin + kNear ? lessColumns<L, kRing>(b, begin, end, j, scaled, own) : lessColumns<L, kRing>(b, j, scaled, last, own);
    storeLanes(x + 4 * j, value);
    last = scaled[static_cast<unsigned>(j) % kRing] = value * row[0];
    if (!staysNear(row))                       // beyond, before anything nearer is taken off there
      for (int i = kNear + 1; i <= kHalf; ++i) storeLanes(x + 4 * (j + i), loadLanes<L>(x + 4 * (j + i)) - row[i] * last);
    if (s.bordered())
      for (int c = 0; c < kBorder; ++c) taken[c] = taken[c] - border[c] * last;
  }
  for (int j = end; j < end + kNear; ++j) storeLanes(x + 4 * j, lessColumns<L, kRing>(b, begin, end, j, scaled, loadLanes<L>(x + 4 * j)));
  for (int c = 0; c < kBorder && s.bordered(); ++c) storeLanes(before + 4 * c, taken[c]);
}

/// One or several sets of right-hand sides: each is a chain of dependent differences, and chains run beside each other.
template <typename L, std::size_t Sets> HALSTED_INLINE void substituteBody(const StretchBand& b, const Stretch& s, std::array<double*, Sets> x) {   // [N] then [m]
  constexpr int kCount = LaneCount<L>::value;
  const int before = 3 * (s.first - 2), end = 3 * (s.last + 1);
  L last[Sets];                                // what the next row waits for stays in a register
  for (std::size_t n = 0; n < Sets; ++n) last[n] = loadLanes<L>(x[n] + kCount * end);
  for (int j = end - 1; j >= 3 * s.first; --j) {
    const double *row = rowOf(b, j), *border = borderOf(b, j);
    for (std::size_t n = 0; n < Sets; ++n) {
      double* own = x[n];
      L sum = lessRow(row, own + kCount * j, last[n], loadLanes<L>(own + kCount * j));
      if (s.bordered())
        for (int c = 0; c < kBorder; ++c) sum = sum - border[c] * loadLanes<L>(own + kCount * (before + c));
      last[n] = sum * row[0];
      storeLanes(own + kCount * j, last[n]);
    }
  }
}

#define HALSTED_WIDE __attribute__((target("avx2")))
HALSTED_WIDE bool eliminateWide(const StretchBand& b, const Stretch& s, double* x) { return eliminateBody(b, s, x); }
HALSTED_WIDE void reduceWide(const StretchBand& b, const Stretch& s, double* x) { reduceBody<Lanes4>(b, s, x); }
HALSTED_WIDE void forwardWide(const StretchBand& b, const Stretch& s, double* x) { forwardBody<Lanes4>(b, s, x); }
HALSTED_WIDE void substituteWide(const StretchBand& b, const Stretch& s, double* x) { substituteBody<Lanes4>(b, s, std::array{x}); }
HALSTED_WIDE void substituteTwiceWide(const StretchBand& b, const Stretch& s, double* x, double* y) { substituteBody<Lanes4>(b, s, std::array{x, y}); }
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

void substitute(const StretchBand& b, const Stretch& s, double* x) { substituteBody<double>(b, s, std::array{x}); }   // [N] then [m]

void forwardFour(const StretchBand& b, const Stretch& s, double* x, LanePath path) {   // [N]
  if (path == LanePath::kWide) forwardWide(b, s, x);
  else forwardBody<Serial4>(b, s, x);
}

void substituteFour(const StretchBand& b, const Stretch& s, double* x, LanePath path) {   // [N] then [m]
  if (path == LanePath::kWide) substituteWide(b, s, x);
  else substituteBody<Serial4>(b, s, std::array{x});
}

void substituteEight(const StretchBand& b, const Stretch& s, double* x, double* y, LanePath path) {   // [N] then [m]
  if (path == LanePath::kWide) substituteTwiceWide(b, s, x, y);
  else substituteBody<Serial4>(b, s, std::array{x, y});
}

}  // namespace halsted
