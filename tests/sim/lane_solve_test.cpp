/// The direct solve of thread that touches itself has the same bits with and without AVX2.
#include <gtest/gtest.h>

#include <random>

#include "sim/strand/envelope.h"
#include "sim/strand/stretch.h"

namespace halsted {
namespace {

bool hasAvx2() { return widestLanes() == LanePath::kWide; }

std::vector<double> numbers(std::size_t count, unsigned seed) {   // [1]
  std::mt19937 random(seed);
  std::vector<double> x(count);
  for (double& value : x) value = std::uniform_real_distribution<>(-1.0, 1.0)(random);
  return x;
}

/// An envelope of ragged rows, its diagonal heavy enough to be positive.
struct Ragged {
  static constexpr int kBlocks = 23;
  std::vector<int> first, offset{0};
  std::vector<double> values, inverse = std::vector<double>(3 * kBlocks), scaled = std::vector<double>(12 * kBlocks);   // [1]

  Ragged() {
    for (int b = 0; b < kBlocks; ++b) {
      first.push_back(b % 5 == 0 ? 0 : b / 2);
      const int wide = 3 * (b + 1 - first[b]);
      offset.push_back(offset.back() + 3 * wide);
    }
    values = numbers(offset.back(), 3);
    for (int b = 0; b < kBlocks; ++b)
      for (int r = 0; r < 3; ++r) values[offset[b] + r * 3 * (b + 1 - first[b]) + 3 * (b - first[b]) + r] += 60.0;
  }
  Envelope view() { return {kBlocks, first.data(), offset.data(), values.data(), inverse.data(), scaled.data()}; }
};

TEST(LaneSolve, FactorsAnEnvelopeToTheSameBits) {
  if (!hasAvx2()) GTEST_SKIP() << "no AVX2";
  Ragged serial, wide;
  ASSERT_TRUE(factorEnvelope(serial.view(), LanePath::kSerial));
  ASSERT_TRUE(factorEnvelope(wide.view(), LanePath::kWide));
  EXPECT_EQ(serial.values, wide.values);
  EXPECT_EQ(serial.inverse, wide.inverse);
}

/// A band of which the middle is eliminated, two blocks before it and two behind it stay.
struct Middle {
  static constexpr int kBlocks = 14;
  std::vector<double> rows, border = std::vector<double>((3 * kBlocks + BandedMatrix::kHalf) * StretchBand::kBorder);   // [1]

  Middle() : rows(numbers((3 * kBlocks + BandedMatrix::kHalf) * BandedMatrix::kStride, 7)) {
    for (int i = 0; i < 3 * kBlocks + BandedMatrix::kHalf; ++i) {
      for (int k = 0; k <= BandedMatrix::kHalf; ++k)
        if (i + k >= 3 * kBlocks) rows[i * BandedMatrix::kStride + k] = 0.0;
      if (i < 3 * kBlocks) rows[i * BandedMatrix::kStride] += 20.0;
    }
    const std::vector<double> coupling = numbers(9 * StretchBand::kBorder, 9);
    std::copy(coupling.begin(), coupling.end(), border.begin() + 3 * stretch().first * StretchBand::kBorder);
  }
  static Stretch stretch() { return {2, kBlocks - 3}; }
  StretchBand view() { return {rows.data(), border.data()}; }
};

TEST(LaneSolve, EliminatesAStretchToTheSameBits) {
  if (!hasAvx2()) GTEST_SKIP() << "no AVX2";
  Middle serial, wide;
  std::vector<double> x = numbers(3 * Middle::kBlocks + BandedMatrix::kHalf, 11), y = x;
  ASSERT_TRUE(eliminate(serial.view(), Middle::stretch(), x.data(), LanePath::kSerial));
  ASSERT_TRUE(eliminate(wide.view(), Middle::stretch(), y.data(), LanePath::kWide));
  reduceBorder(serial.view(), Middle::stretch(), x.data(), LanePath::kSerial);
  reduceBorder(wide.view(), Middle::stretch(), y.data(), LanePath::kWide);
  EXPECT_EQ(x, y);
  EXPECT_EQ(serial.rows, wide.rows);
  EXPECT_EQ(serial.border, wide.border);
}

}  // namespace
}  // namespace halsted
