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
  L sum = loadLanes<L>(std::array<double, 4>{}.data());
  int k = 0;
  for (; k + 4 <= n; k += 4) sum = sum + loadLanes<L>(a + k) * loadLanes<L>(b + k);
  double total = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  for (; k < n; ++k) total += a[k] * b[k];
  return total;
}

/// Three of them with the same `b` at once, each to the bits of `dot`. [any]
template <typename L> HALSTED_INLINE std::array<double, 3> threeDots(std::array<const double*, 3> a, const double* b, int n) {
  L x = loadLanes<L>(std::array<double, 4>{}.data()), y = x, z = x;
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    const L other = loadLanes<L>(b + k);
    x = x + loadLanes<L>(a[0] + k) * other;
    y = y + loadLanes<L>(a[1] + k) * other;
    z = z + loadLanes<L>(a[2] + k) * other;
  }
  std::array<double, 3> total{(x[0] + x[1]) + (x[2] + x[3]), (y[0] + y[1]) + (y[2] + y[3]), (z[0] + z[1]) + (z[2] + z[3])};
  for (; k < n; ++k)
    for (int r = 0; r < 3; ++r) total[r] += a[r][k] * b[k];
  return total;
}

/// Row i of L times the pivots stands in `scaled` while it is being made; the three rows of a block are made side by side, as far as the
/// diagonal block, where each needs the one before.
template <typename L> HALSTED_INLINE bool factorBody(const Envelope& e) {
  const std::array<double*, 3> scaled{e.scaled, e.scaled + 3 * e.blocks, e.scaled + 6 * e.blocks};   // [N/m]
  for (int block = 0; block < e.blocks; ++block) {
    const BlockRow a(e, block);
    double pivot[3] = {};                      // [N/m]
    for (int r = 0; r < 3; ++r) pivot[r] = a.row[r][a.diagonal + r - a.begin];
    for (int j = a.begin; j < a.diagonal; ++j) {
      const BlockRow other(e, j / 3);
      const int from = std::max(a.begin, other.begin);
      const auto sum = threeDots<L>({scaled[0] + from, scaled[1] + from, scaled[2] + from}, other.row[j % 3] + from - other.begin, j - from);
      for (int r = 0; r < 3; ++r) scaled[r][j] = a.row[r][j - a.begin] - sum[r];
    }
    for (int j = a.begin; j < a.diagonal; ++j)
      for (int r = 0; r < 3; ++r) {
        const double l = scaled[r][j] * e.inverse[j];   // [1]
        pivot[r] -= l * scaled[r][j];
        a.row[r][j - a.begin] = l;
      }
    for (int r = 0; r < 3; ++r) {
      for (int j = a.diagonal; j < a.diagonal + r; ++j)
        scaled[r][j] = a.row[r][j - a.begin] - dot<L>(scaled[r] + a.begin, a.row[j - a.diagonal], j - a.begin);
      for (int j = a.diagonal; j < a.diagonal + r; ++j) {
        const double l = scaled[r][j] * e.inverse[j];   // [1]
        pivot[r] -= l * scaled[r][j];
        a.row[r][j - a.begin] = l;
      }
      if (!(pivot[r] > 0.0)) return false;
      e.inverse[a.diagonal + r] = 1.0 / pivot[r];
    }
  }
  return true;
}

template <typename L> HALSTED_INLINE void solveBody(const Envelope& e, double* x) {   // [N] then [m]
  for (int block = 0; block < e.blocks; ++block) {
    const BlockRow l(e, block);
    L sum[3];
    for (L& s : sum) s = loadLanes<L>(std::array<double, 4>{}.data());
    for (int k = l.begin; k < l.diagonal; ++k) {
      const L other = loadLanes<L>(x + 4 * k);
      for (int r = 0; r < 3; ++r) sum[r] = sum[r] + l.row[r][k - l.begin] * other;
    }
    for (int r = 0; r < 3; ++r) {
      for (int k = l.diagonal; k < l.diagonal + r; ++k) sum[r] = sum[r] + l.row[r][k - l.begin] * loadLanes<L>(x + 4 * k);
      storeLanes(x + 4 * (l.diagonal + r), loadLanes<L>(x + 4 * (l.diagonal + r)) - sum[r]);
    }
  }
  for (int i = 0; i < 3 * e.blocks; ++i) storeLanes(x + 4 * i, loadLanes<L>(x + 4 * i) * e.inverse[i]);
  for (int block = e.blocks - 1; block >= 0; --block) {
    const BlockRow l(e, block);
    L own[3];
    for (int r = 0; r < 3; ++r) own[r] = loadLanes<L>(x + 4 * (l.diagonal + r));
    for (int r = 2; r > 0; --r)
      for (int k = 0; k < r; ++k) own[k] = own[k] - l.row[r][l.diagonal + k - l.begin] * own[r];
    for (int r = 0; r < 3; ++r) storeLanes(x + 4 * (l.diagonal + r), own[r]);
    for (int j = l.begin; j < l.diagonal; ++j) {
      L value = loadLanes<L>(x + 4 * j);
      for (int r = 2; r >= 0; --r) value = value - l.row[r][j - l.begin] * own[r];
      storeLanes(x + 4 * j, value);
    }
  }
}

__attribute__((target("avx2"))) bool factorWide(const Envelope& e) { return factorBody<Lanes4>(e); }
bool factorNarrow(const Envelope& e) { return factorBody<Serial4>(e); }
__attribute__((target("avx2"))) void solveWide(const Envelope& e, double* x) { solveBody<Lanes4>(e, x); }   // [N] then [m]
void solveNarrow(const Envelope& e, double* x) { solveBody<Serial4>(e, x); }                                // [N] then [m]

}  // namespace

bool factorEnvelope(const Envelope& e, LanePath path) { return path == LanePath::kWide ? factorWide(e) : factorNarrow(e); }

void solveEnvelopeFour(const Envelope& e, double* x, LanePath path) {   // [N] then [m]
  if (path == LanePath::kWide) solveWide(e, x);
  else solveNarrow(e, x);
}

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
