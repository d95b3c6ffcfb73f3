#pragma once
/// Cross-sections of a tube-like surface: how far the wall is from the centreline in every direction.
#include <vector>

#include "scenes/mesh_readers/surface.h"

namespace halsted::scenes {

/// A plane across the tube. right, up, normal are orthonormal and right-handed.
struct SectionFrame {
  Vec3 centre = Vec3::Zero();      // [m]
  Vec3 right = Vec3::UnitX();      // [1] direction of ray 0
  Vec3 up = Vec3::UnitY();         // [1]
  Vec3 normal = Vec3::UnitZ();     // [1]
};

/// Turned as little as possible so that its normal is `normal`.
SectionFrame transported(const SectionFrame&, const Vec3& centre, const Vec3& normal);

/// A frame across `normal` whose up is as near to +y as that allows (to -z when the tube runs along y).
SectionFrame uprightFrame(const Vec3& centre, const Vec3& normal);

/// Distance to the wall per ray, counter-clockwise from `right`. Missing rays hold kMissing.
struct Section {
  static constexpr double kMissing = -1.0;   // [m] no distance
  std::vector<double> radius;      // [m]

  int missing() const;
  /// Rays longer than `longest` hit another loop through a hole: they become missing.
  void dropBeyond(double longest); // [m]
  /// Missing rays from their neighbours round the section; needs one ray.
  void fill();
  double meanRadius() const;       // [m] of the circle of equal area; needs filled rays
  Vec3 centroid(const SectionFrame&) const;   // [m] needs filled rays
};

/// Cuts one surface many times, each time looking only at triangles near the plane. Keeps a reference to the surface.
class TubeSlicer {
 public:
  /// `wallGap`: walls this near behind the first are the same (double) wall, and the outermost counts.  [m]
  TubeSlicer(const Surface& surface, double wallGap);
  Section cut(const SectionFrame&, int rays) const;

 private:
  /// Triangles that lie close together, and the box round them.
  struct Cluster {
    int begin = 0, end = 0;        // in order_
    Vec3 centre = Vec3::Zero();    // [m]
    Vec3 half = Vec3::Zero();      // [m]
  };
  using Piece = std::array<Eigen::Vector2d, 2>;   // [m] in the plane's own coordinates
  std::vector<Piece> slice(const SectionFrame&) const;

  const Surface& surface_;
  double wallGap_ = 0.0;           // [m]
  std::vector<int> order_;         // triangles along a space-filling curve
  std::vector<Cluster> clusters_;
};

}  // namespace halsted::scenes
