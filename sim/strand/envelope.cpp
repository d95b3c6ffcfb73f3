#include "sim/strand/envelope.h"

#include <algorithm>
#include <array>

namespace halsted {
namespace {

/// The three scalar rows of a block row; columns count from `begin`, the diagonal block from `diagonal`.
struct BlockRow {
  int begin, diagonal;
  double* row[3];                              // [N/m]

  BlockRow(const Envelope& e, int block) : begin(3 * e.first[block]), diagonal(3 * block) {
    for (int r = 0; r < 3; ++r) row[r] = e.values + e.offset[block] + r * (diagonal + 3 - begin);
  }
};

/// Four partial sums in a fixed order: no chain of dependent additions. [any]
template <typename L> HALSTED_INLINE double dot(const double* a, const double* b, int n) {
  L sum = zeroLanes<L>();
  int k = 0;
  for (; k + 4 <= n; k += 4) sum = sum + loadLanes<L>(a + k) * loadLanes<L>(b + k);
  double total = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  for (; k < n; ++k) total += a[k] * b[k];
  return total;
}

/// Products of three rows, side by side, with one more row: a sum for each place of four, in the end added up as `dot` does.
template <typename L> struct FourSums {
  L part[4];                                   // [N/m]

  HALSTED_INLINE FourSums() {
    for (L& p : part) p = zeroLanes<L>();
  }
  HALSTED_INLINE void add(const L* three, const double* one) {
    for (int q = 0; q < 4; ++q) part[q] = part[q] + three[q] * one[q];
  }
  /// With those of the last `Rest` columns, of which four fill one more column of sums.
  template <int Rest> HALSTED_INLINE L total(const L* three, const double* one) {
    constexpr int kFull = Rest < 4 ? 0 : 4;
    if constexpr (kFull == 4) add(three, one);
    L sum = (part[0] + part[1]) + (part[2] + part[3]);
    for (int q = kFull; q < Rest; ++q) sum = sum + three[q] * one[q];
    return sum;
  }
};

/// The three rows of a block while L is made of them, side by side: a lane is a row. What a column comes to is a factor in the next, so it
/// is handed on in a register; L times the pivots stands in `scaled`.
template <typename L> struct RowsAbreast {
  const Envelope& e;
  const BlockRow a;
  L pivot;                                     // [N/m]

  HALSTED_INLINE RowsAbreast(const Envelope& envelope, int block) : e(envelope), a(envelope, block), pivot(zeroLanes<L>()) {
    const int d = a.diagonal - a.begin;
    pivot = loadLanes<L>(std::array<double, 4>{a.row[0][d], a.row[1][d + 1], a.row[2][d + 2], 0.0}.data());
  }

  /// Makes the entries of column j. On the diagonal and above it what comes of this is not read.
  HALSTED_INLINE L enter(int j, L taken) {
    const int at = j - a.begin;
    const L own = loadLanes<L>(std::array<double, 4>{a.row[0][at], a.row[1][at], a.row[2][at], 0.0}.data());
    const L scaled = own - taken, entry = scaled * e.inverse[j];
    storeLanes(e.scaled + 4 * j, scaled);
    for (int r = 0; r < 3; ++r) a.row[r][at] = entry[r];
    pivot = pivot - entry * scaled;
    return scaled;
  }
  HALSTED_INLINE bool invertPivot(int c) {
    e.inverse[a.diagonal + c] = 1.0 / pivot[c];
    return pivot[c] > 0.0;
  }

  /// Sums over the columns before the diagonal of `other`, four at a time; returns where fewer than four are left.
  template <int Rows> HALSTED_INLINE int sumFours(const BlockRow& other, FourSums<L>* sums) const {
    int k = std::max(a.begin, other.begin);
    for (; k + 4 <= other.diagonal; k += 4) {
      L three[4];
      for (int q = 0; q < 4; ++q) three[q] = loadLanes<L>(e.scaled + 4 * (k + q));
      for (int c = 0; c < Rows; ++c) sums[c].add(three, other.row[c] + k - other.begin);
    }
    return k;
  }

  /// The three columns of an earlier block, `Rest` columns after `begin`.
  template <int Rest> HALSTED_INLINE void enterBlock(const BlockRow& other, FourSums<L>* sums, int begin) {
    const int at = begin - other.begin;
    L last[Rest + 2];
    for (int q = 0; q < Rest; ++q) last[q] = loadLanes<L>(e.scaled + 4 * (begin + q));
    last[Rest] = enter(other.diagonal, sums[0].template total<Rest>(last, other.row[0] + at));
    last[Rest + 1] = enter(other.diagonal + 1, sums[1].template total<Rest + 1>(last, other.row[1] + at));
    enter(other.diagonal + 2, sums[2].template total<Rest + 2>(last, other.row[2] + at));
  }
  HALSTED_INLINE void enterBlock(int block) {
    const BlockRow other(e, block);
    FourSums<L> sums[3];
    const int begin = sumFours<3>(other, sums);
    switch (other.diagonal - begin) {
      case 0: return enterBlock<0>(other, sums, begin);
      case 1: return enterBlock<1>(other, sums, begin);
      case 2: return enterBlock<2>(other, sums, begin);
      default: return enterBlock<3>(other, sums, begin);
    }
  }

  /// The block's own columns: false when a pivot is not positive.
  template <int Rest> HALSTED_INLINE bool close(FourSums<L>* sums, int begin) {
    const int at = begin - a.begin;
    L last[Rest + 1];
    for (int q = 0; q < Rest; ++q) last[q] = loadLanes<L>(e.scaled + 4 * (begin + q));
    if (!invertPivot(0)) return false;
    last[Rest] = enter(a.diagonal, sums[0].template total<Rest>(last, a.row[0] + at));
    if (!invertPivot(1)) return false;
    enter(a.diagonal + 1, sums[1].template total<Rest + 1>(last, a.row[1] + at));
    return invertPivot(2);
  }
  HALSTED_INLINE bool close() {
    FourSums<L> sums[2];
    const int begin = sumFours<2>(a, sums);
    switch (a.diagonal - begin) {
      case 0: return close<0>(sums, begin);
      case 1: return close<1>(sums, begin);
      case 2: return close<2>(sums, begin);
      default: return close<3>(sums, begin);
    }
  }
};

template <typename L> HALSTED_INLINE bool factorBody(const Envelope& e) {
  for (int block = 0; block < e.blocks; ++block) {
    RowsAbreast<L> rows(e, block);
    for (int earlier = e.first[block]; earlier < block; ++earlier) rows.enterBlock(earlier);
    if (!rows.close()) return false;
  }
  return true;
}

__attribute__((target("avx2"))) bool factorWide(const Envelope& e) { return factorBody<Lanes4>(e); }
bool factorNarrow(const Envelope& e) { return factorBody<Serial4>(e); }

}  // namespace

bool factorEnvelope(const Envelope& e, LanePath path) { return path == LanePath::kWide ? factorWide(e) : factorNarrow(e); }

void solveEnvelope(const Envelope& e, double* x) {   // [N] then [m]
  for (int block = 0; block < e.blocks; ++block) {
    const BlockRow l(e, block);
    for (int r = 0; r < 3; ++r) x[l.diagonal + r] -= dot<Serial4>(l.row[r], x + l.begin, l.diagonal + r - l.begin);
  }
  for (int i = 0; i < 3 * e.blocks; ++i) x[i] *= e.inverse[i];
  for (int block = e.blocks - 1; block >= 0; --block) {
    const BlockRow l(e, block);
    for (int r = 2; r >= 0; --r)
      for (int j = l.begin; j < l.diagonal + r; ++j) x[j] -= l.row[r][j - l.begin] * x[l.diagonal + r];
  }
}

}  // namespace halsted
