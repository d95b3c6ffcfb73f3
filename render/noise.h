#pragma once
/// Smooth pseudo-random fields for colours and textures: value noise on an integer lattice. Deterministic; no state.
namespace halsted::render {

/// In [0, 1]; smooth over a distance of 1. `period` > 0 makes it repeat in x and y.
double noise(double x, double y, double z, int period = 0);            // all [1]
/// Sum of `octaves` of noise, each twice as fine and half as strong; in [0, 1].
double fractalNoise(double x, double y, double z, int octaves, int period = 0);   // all [1]
/// 0 below `low`, 1 above `high`, smooth between.
double smoothStep(double low, double high, double x);                  // all [1]

}  // namespace halsted::render
