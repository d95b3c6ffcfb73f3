#pragma once
/// Overlapping shape-matching clusters with the counts of paper 003: the preset `paper`. It has no material (physics.md 0.2).
#include <vector>

#include "sim/types.h"

namespace halsted {

struct ShapeMatchingModel {
  int substeps = 8;                            // [1] per frame of 12 ms in the paper; here per dt
  int iterations = 2;                          // [1]
  double resistance = 0.65;                    // [1]
  std::vector<int> clusterStart;               // prefix sums into `member`, size clusters + 1
  std::vector<int> member;                     // particle indices, ascending within a cluster
  std::vector<Vec3> restOffset;                // [m] per member: rest position - rest centroid
};

}  // namespace halsted
