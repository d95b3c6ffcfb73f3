#pragma once
/// One level of Loop subdivision on rows of weights. Used by skin.cpp only.
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace halsted::render {

using WeightRow = std::vector<std::pair<std::uint32_t, double>>;   // (particle, weight [1]), ascending by particle

struct ControlMesh {
  std::vector<WeightRow> rows;                           // per vertex
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::array<double, 2>, 3>> uv;  // per triangle corner (turn [1], length [m])
  std::vector<int> layers;                               // per triangle
};

/// out += factor * row
void addRow(WeightRow& out, const WeightRow& row, double factor);  // factor [1]

enum class Rule { kLoop, kFlat };                        // flat: vertices stay, edges are halved

/// Four triangles for each. The first vertices of the result are those of `mesh`, moved by the Loop rule. Points come in the same order
/// by either rule.
ControlMesh subdivide(const ControlMesh& mesh, Rule rule = Rule::kLoop);

}  // namespace halsted::render
