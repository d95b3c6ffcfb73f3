#pragma once
/// Smooth pseudo-random fields for colours and textures: value noise on an integer lattice. Deterministic.
#include <array>
#include <cstdint>

namespace halsted::render {

/// In [0, 1]; smooth over a distance of 1.
double noise(double x, double y, double z);                            // all [1]
/// Sum of `octaves` of noise, each twice as fine and half as strong; in [0, 1].
double fractalNoise(double x, double y, double z, int octaves);        // all [1]
/// fractalNoise for points that follow one another along x, as the texels of an image do: the two ends of a lattice cell are kept
/// until the walk leaves it, which makes it several times faster. Starting anywhere gives the same values, but for rounding.
/// `period` > 0 makes it repeat in x and y.
class NoiseWalk {
 public:
  explicit NoiseWalk(int octaves, int period = 0) : octaves_(octaves), period_(period) {}   // at most 6 octaves
  double at(double x, double y, double z);                             // all [1]

 private:
  struct Cell { int i = 0; double y = 0.0, z = 0.0, near = 0.0, far = 0.0; bool known = false; };   // all [1]
  double octave(Cell&, double x, double y, double z, int period) const;   // all [1]

  int octaves_, period_;
  std::array<Cell, 6> cells_;
};

/// In [0, 1): the next of a row of numbers that look like chance (Numerical Recipes' linear congruential generator).
double nextRandom(std::uint32_t& seed);                                // [1]

/// 0 below `low`, 1 above `high`, smooth between.
double smoothStep(double low, double high, double x);                  // all [1]

}  // namespace halsted::render
