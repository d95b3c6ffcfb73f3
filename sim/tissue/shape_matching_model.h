#pragma once
/// Overlapping shape-matching clusters with the counts of paper 003: the preset `paper`. It has no material (physics.md 0.2).
/// One cluster per particle: the particle and its nearest neighbours along the mesh.
#include <vector>

#include "sim/lane_math.h"
#include "sim/types.h"

namespace halsted {

struct TissueModel;
struct TissueParams;

/// Many lists of maps to be summed, with what several of them have in common summed once. A node is an input, a shared sum, or, after
/// all of these, the empty map that fills up shorter lists.
struct SumPlan {
  static constexpr int kLists = 4;             // are summed side by side, each as long as the longest; the last group repeats the last list
  std::vector<int> shared;                     // two nodes each, times kMap; earlier ones only
  std::vector<int> start, node;                // per group of lists: prefix sums; nodes times kMap, by place in the list, then list
};

struct ShapeMatchingModel {
  static constexpr int kMembers = 20;          // per cluster, fewer only where the mesh itself is smaller
  static constexpr int kMap = 12;              // doubles of an affine map
  int substeps = 8;                            // [1] per frame of 12 ms in the paper; here per dt
  int iterations = 2;                          // [1]
  double resistance = 0.65;                    // [1]
  Vec3 origin = Vec3::Zero();                  // [m] rest centroid of all particles; sums are taken about it to keep digits
  std::vector<int> clusterStart;               // prefix sums into `member`, size clusters + 1
  std::vector<int> member;                     // particle indices, ascending within a cluster
  std::vector<int> ownerStart;                 // prefix sums into `owner`, size particles + 1
  std::vector<int> owner;                      // clusters that hold a particle, ascending
  SumPlan gather, spread;                      // moments of members into clusters, maps of owners into particles
  // A particle's mass is shared equally among its clusters: then averaging the goals conserves momentum. Both the share and the mean
  // are in `rest`.
  std::vector<double> rest;                    // per particle: x, y, z of rest - origin [m], 1; all divided by the clusters that hold it
  std::vector<double> mass;                    // [kg] per particle
  std::vector<double> laneCentre;              // per four clusters, lane by lane: x, y, z of the mass centre - origin [m], 1 / sum of shares [1/kg]
  LanePath path = LanePath::kSerial;           // set by the builder to the widest the CPU has
};

/// Lists of inputs 0 .. inputs - 1 -> the plan of their sums.
SumPlan planSums(std::vector<std::vector<int>> lists, int inputs);

/// Fills `model.shape`; needs rest positions, tets and masses.
void buildShapeMatching(TissueModel& model, const TissueParams&);

}  // namespace halsted
