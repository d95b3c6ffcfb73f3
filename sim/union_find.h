#pragma once
/// Sets of indices that are joined pair by pair (Tarjan 1975, path halving). `parent[v] == v` for every v at first. No heap.
#include <vector>

namespace halsted {

inline int rootOf(std::vector<int>& parent, int v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

/// The smaller index is the root: the same whatever the order of the joins.
inline void join(std::vector<int>& parent, int a, int b) {
  a = rootOf(parent, a);
  b = rootOf(parent, b);
  if (a < b) parent[b] = a;
  else parent[a] = b;
}

}  // namespace halsted
