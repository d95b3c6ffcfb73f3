#pragma once
/// Symmetric positive definite matrix of fixed half bandwidth, and its direct solve in linear time. No heap after `resize`.
#include <vector>

namespace halsted {

class BandedMatrix {
 public:
  static constexpr int kHalf = 11;             // half bandwidth: bending couples blocks two apart, the needle block is 6 wide
  static constexpr int kBending = 8;           // of it, what all rows use but those beside the needle's block
  static constexpr int kStride = kHalf + 1;

  void resize(int size) {
    size_ = size;
    entries_.assign(static_cast<std::size_t>(size + kHalf) * kStride, 0.0);
  }
  int size() const { return size_; }
  void setZero() { entries_.assign(entries_.size(), 0.0); }

  /// Adds to entry (i, j); |i - j| <= kHalf. Only the upper part is stored.
  void add(int i, int j, double value) {   // [1]
    if (i <= j) entries_[static_cast<std::size_t>(i) * kStride + (j - i)] += value;
  }
  double at(int i, int j) const {
    if (i > j) { const int k = i; i = j; j = k; }
    return j - i > kHalf ? 0.0 : entries_[static_cast<std::size_t>(i) * kStride + (j - i)];
  }

  /// Rows of kStride, A(i, i) first; what would lie beyond the last column is zero, as are kHalf rows behind the last.
  double* rows() { return entries_.data(); }   // [1]

  /// LDL^T in place, then x := A^-1 x. False when a pivot is not positive (the matrix is then useless).
  bool factorAndSolve(double* x);

 private:
  int size_ = 0;
  std::vector<double> entries_;                // [1] row i: A(i, i) .. A(i, i + kHalf)
};

}  // namespace halsted
