#pragma once
/// Which bowel of the scene each vertex belongs to, and its rim: one tube has one, two ends to be joined have two. A bowel is a connected
/// piece of the mesh, or what `TetMesh::bowel` says; its rim is the part of `TetMesh::rim` that lies on it. Built at load time, constant afterwards.
#include <span>
#include <vector>

#include "sim/mesh.h"

namespace halsted {

/// An open end as the surgeon at that end sees it: angles run from `right` over `up`, the bowel lies behind it.
struct Opening {
  Vec3 centre = Vec3::Zero();                  // [m]
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), axis = Vec3::UnitZ();   // [1] axis points out of the bowel
};

struct Bowels {
  int count = 0;
  std::vector<Opening> opening;                // per bowel, at rest
  std::vector<int> of;                         // per vertex: its bowel
  std::vector<std::vector<int>> rim;           // per bowel, in order round the opening
  std::vector<double> wallDepth;               // [1] per vertex: 0 on the serosa, 1 on the mucosa, 0.5 between two layers
};

Bowels findBowels(const TetMesh&);

Vec3 centreOf(std::span<const int> rim, std::span<const Vec3> x);          // [m] mean of its vertices
/// Area enclosed by a rim's outline.  [m^2]
double enclosedArea(std::span<const int> rim, std::span<const Vec3> x);

}  // namespace halsted
