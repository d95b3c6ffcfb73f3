/// What is read four doubles at a time begins with a cache line, however it came to be.
#include "sim/line_vector.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "sim/state.h"

namespace halsted {
namespace {

bool beginsALine(const LineVector<double>& v) { return reinterpret_cast<std::uintptr_t>(v.data()) % 64 == 0; }   // [any]

TEST(LineVector, BeginsWithACacheLine) {
  for (std::size_t size : {1u, 7u, 12u, 1000u, 65537u}) {
    LineVector<double> v(size, 1.0);
    EXPECT_TRUE(beginsALine(v)) << size;
    LineVector<double> grown = v;
    for (std::size_t k = 0; k < size + 5; ++k) grown.push_back(2.0);
    EXPECT_TRUE(beginsALine(grown)) << size;
    EXPECT_EQ(grown[size - 1], 1.0);
    const LineVector<double> moved = std::move(grown);
    EXPECT_TRUE(beginsALine(moved)) << size;
  }
}

TEST(LineVector, HoldsTheRowsOfTheTissuesSolve) {
  TissueWork work;
  work.rows.resize(4 * 17);
  work.scratch.resize(12 * 5);
  EXPECT_TRUE(beginsALine(work.rows));
  EXPECT_TRUE(beginsALine(work.scratch));
}

}  // namespace
}  // namespace halsted
