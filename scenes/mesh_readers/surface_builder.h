#pragma once
/// Collects what a mesh reader finds, checks every vertex and index, and welds at the end.
#include <functional>
#include <string>
#include <vector>

#include "scenes/mesh_readers/surface.h"

namespace halsted::scenes {

class SurfaceBuilder {
 public:
  /// `where` names the place being read, for messages. scale [m per unit]
  SurfaceBuilder(double scale, std::function<std::string()> where) : scale_(scale), where_(std::move(where)) {}

  void limitVertices(std::size_t most) { mostVertices_ = most; }
  /// Refuses a declared count before anything of it is read.
  void announceVertices(long long count) const;
  void announceTriangles(long long count) const;

  void addVertex(const Vec3& position);             // [mesh units]
  /// A polygon's corners one by one, zero-based; from the third on, each adds a triangle of the fan.
  void beginPolygon() { corners_ = 0; }
  void addCorner(long long vertex);
  void endPolygon() const;
  void beginGroup(const std::string& name);

  std::size_t vertexCount() const { return surface_.vertices.size(); }
  [[noreturn]] void fail(const std::string& message) const;

  /// Welds and returns the surface; throws when nothing is left.
  Surface finish();

 private:
  double scale_ = 1.0;                              // [m per unit]
  std::function<std::string()> where_;
  std::size_t mostVertices_ = kMostVertices;
  Surface surface_;
  long long corners_ = 0;
  int first_ = 0, previous_ = 0;
};

/// Merges vertices closer than about a millionth of the surface's size and drops the triangles that this leaves without area.
void weld(Surface&);

}  // namespace halsted::scenes
