#include "sim/suture/exchange.h"

#include <algorithm>

#include "sim/lanes.h"

namespace halsted {
namespace {

template <std::size_t N> int heaviest(const std::array<double, N>& weight) {   // [1]
  return static_cast<int>(std::max_element(weight.begin(), weight.end()) - weight.begin());
}

void add(int vertex, VertexCount& list) {
  for (int i = 0; i < list.count; ++i)
    if (list.vertex[i] == vertex) { ++list.times[i]; return; }
  static_assert(VertexCount::kMost >= StrandState::kMaxContacts && VertexCount::kMost >= StrandState::kMaxHoles);
  list.vertex[list.count] = vertex;
  list.times[list.count++] = 1;
}

double rowSum(const Model& m, int vertex, const VertexCount& list) {   // [m/N]
  double sum = 0.0;
  for (int i = 0; i < list.count; ++i) sum += list.times[i] * magnitude(compliance(m.tissue.projective, vertex, list.vertex[i]));
  return sum;
}

/// Many samples lie by the same vertex, and every sum reads all over a matrix of megabytes.
double remembered(const Model& m, int vertex, const VertexCount& list, RowSums& known) {   // [m/N]
  for (int i = 0; i < known.count; ++i)
    if (known.vertex[i] == vertex) return known.sum[i];
  const double sum = rowSum(m, vertex, list);
  if (known.count == VertexCount::kMost) return sum;
  known.vertex[known.count] = vertex;
  known.sum[known.count++] = sum;
  return sum;
}

}  // namespace

bool sumsExchange(const Model& m, const State& s) { return m.params.thread.knots && m.bowels.count > 1 && !s.cut; }

int vertexOf(const Model& m, const Hole& h) { return m.tissue.tets[h.tet][heaviest(h.weight)]; }
int vertexOf(const Model& m, int triangle, const std::array<double, 3>& weight) { return m.surface.triangles[triangle][heaviest(weight)]; }

void gatherExchange(const Model& m, const StrandState& s, ExchangeWork& w) {
  w.contacts.count = w.holes.count = w.byContacts.count = w.byHoles.count = 0;
  const int triangles = static_cast<int>(m.surface.triangles.size());
  for (int i = 0; i < s.contactCount; ++i) {
    const StrandContact& c = s.contacts[i];
    if (c.feature < triangles) add(vertexOf(m, c.feature, c.weight), w.contacts);
  }
  for (int i = 0; i < s.holeCount; ++i) add(vertexOf(m, s.holes[i]), w.holes);
}

double movedByContacts(const Model& m, int vertex, ExchangeWork& w) { return remembered(m, vertex, w.contacts, w.byContacts); }
double movedByHoles(const Model& m, int vertex, ExchangeWork& w) { return remembered(m, vertex, w.holes, w.byHoles); }

}  // namespace halsted
