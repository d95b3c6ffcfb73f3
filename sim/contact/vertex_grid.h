#pragma once
/// The surface's vertices in a grid of cells, and the order in which a search through the cells meets them. No heap.
#include <algorithm>
#include <array>
#include <span>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

using Cell = std::array<int, 3>;

inline constexpr double kLeastCell = 3e-3;       // [m] about one edge of the mesh

/// Cells of a box about all vertices, each axis divided alike: however far the tissue is stretched there are no more of them.
class VertexGrid {
 public:
  VertexGrid(const Model& m, std::span<const Vec3> x) : low_(x[m.surface.vertices.front()]) {   // x [m]
    Vec3 high = low_;                            // [m]
    for (int v : m.surface.vertices) {
      low_ = low_.cwiseMin(x[v]);
      high = high.cwiseMax(x[v]);
    }
    for (int axis = 0; axis < 3; ++axis) perMetre_[axis] = 1.0 / std::max(kLeastCell, (high[axis] - low_[axis]) / SelfWork::kAxis);
  }
  Cell at(const Vec3& p) const {                 // [m]
    Cell c;
    for (int axis = 0; axis < 3; ++axis) {
      const double cells = (p[axis] - low_[axis]) * perMetre_[axis];   // [1]
      c[axis] = cells > 0.0 ? static_cast<int>(std::min(cells, SelfWork::kAxis - 1.0)) : 0;
    }
    return c;
  }
  static int index(int x, int y, int z) { return (x * SelfWork::kAxis + y) * SelfWork::kAxis + z; }
  int indexAt(const Vec3& p) const {             // [m]
    const Cell c = at(p);
    return index(c[0], c[1], c[2]);
  }

 private:
  Vec3 low_;                                     // [m]
  Vec3 perMetre_ = Vec3::Zero();                 // [1/m]
};

/// Counting sort of the surface's vertices into cells: index order within a cell.
inline void fillGrid(const Model& m, const TissueState& t, const VertexGrid& grid, SelfWork& w) {
  w.start.fill(0);
  const int n = static_cast<int>(m.surface.vertices.size());
  for (int i = 0; i < n; ++i) {
    w.cell[i] = grid.indexAt(t.position[m.surface.vertices[i]]);
    ++w.start[w.cell[i] + 1];
  }
  for (int c = 0; c < SelfWork::kCells; ++c) w.start[c + 1] += w.start[c];
  for (int i = n - 1; i >= 0; --i) {             // from the last: afterwards start[c + 1] is where cell c begins
    const int at = --w.start[w.cell[i] + 1];
    w.item[at] = m.surface.vertices[i];
    for (int axis = 0; axis < 3; ++axis) w.place[at + axis * n] = t.position[m.surface.vertices[i]][axis];
  }
  std::copy(w.start.begin() + 1, w.start.end(), w.start.begin());
  w.start[SelfWork::kCells] = n;
}

}  // namespace halsted
