#pragma once
/// Motion of tissue and thread, as the laws of random hands weigh it.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

inline double kineticEnergy(const Model& m, const State& s) {   // [J] of tissue and thread
  double sum = 0.0;                              // [J]
  for (std::size_t i = 0; i < s.tissue.velocity.size(); ++i) sum += 0.5 * m.tissue.mass[i] * s.tissue.velocity[i].squaredNorm();
  for (std::size_t i = 0; i < s.strand.velocity.size(); ++i) sum += 0.5 * m.strand.mass[i] * s.strand.velocity[i].squaredNorm();
  return sum;
}

}  // namespace halsted
