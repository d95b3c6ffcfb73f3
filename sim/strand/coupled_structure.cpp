/// Which nodes couple, and in which order the core is eliminated.
#include <algorithm>

#include "sim/strand/coupled_solve.h"

namespace halsted {

void CoupledSolve::clearStructure() {
  std::fill(inCore_.begin(), inCore_.end(), 0);
  core_.clear();
  pairs_.clear();
  handPairs_.clear();
  stretches_.clear();
}

bool CoupledSolve::couple(int nodeA, int nodeB) {
  if (!pairs_.empty() && pairs_.back() == std::pair(nodeA, nodeB)) return true;
  if (pairs_.size() >= kMaxPairs) return false;
  if (!enterThree(nodeA) || !enterThree(nodeB)) return false;
  pairs_.emplace_back(nodeA, nodeB);
  return true;
}

bool CoupledSolve::coupleHand(int hand, int node) {
  if (!handPairs_.empty() && handPairs_.back() == std::pair(hand, node)) return true;
  if (handPairs_.size() >= kMaxPairs || !enter(handBlock(hand)) || !enterThree(node)) return false;
  handPairs_.emplace_back(hand, node);
  return true;
}

bool CoupledSolve::enter(int block) {
  if (inCore_[block]) return true;
  if (coreNodes() >= kMaxCore) return false;
  core_.push_back(block);
  inCore_[block] = 1;
  return true;
}

bool CoupledSolve::enterThree(int node) { return enter(node) && enter(node + 1) && enter(node + 2); }

int CoupledSolve::handsHeld() const {
  int count = 0;
  for (int hand = 0; hand < kHands; ++hand) count += holdsHand(hand) ? 1 : 0;
  return count;
}

void CoupledSolve::findStretches() {
  for (int b = 0; b < blocks_;) {
    if (inCore_[b]) { ++b; continue; }
    int last = b;
    while (last + 1 < blocks_ && !inCore_[last + 1]) ++last;
    stretches_.push_back({b, last});
    b = last + 1;
  }
}

void CoupledSolve::connect(int nodeI, int nodeJ) {
  const int i = place_[nodeI], j = place_[nodeJ];
  graph_[static_cast<std::size_t>(i) * kMaxCore + j] = graph_[static_cast<std::size_t>(j) * kMaxCore + i] = 1;
}

/// What couples in the core: neighbours within the band, the two sides of a free stretch, contacts.
void CoupledSolve::linkNeighbours() {
  const int n = coreNodes();
  for (int i = 0; i < n; ++i) std::fill_n(graph_.begin() + static_cast<std::size_t>(i) * kMaxCore, n, 0);
  for (int node : core_)
    for (int back = 0; back <= (node < blocks_ ? 3 : 0) && node - back >= 0; ++back)
      if (inCore_[node - back]) connect(node, node - back);
  for (const Stretch& s : stretches_) {
    if (s.first < 2 || s.last + 2 >= blocks_) continue;
    for (int i = 1; i <= 2; ++i)
      for (int j = 1; j <= 2; ++j) connect(s.last + i, s.first - j);
  }
  for (const auto& [a, b] : pairs_)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) connect(a + i, b + j);
  for (const auto& [hand, node] : handPairs_)
    for (int i = 0; i < 3; ++i) connect(handBlock(hand), node + i);
}

/// Reverse Cuthill-McKee: breadth first from a node of least degree, neighbours of lesser degree first, then backward. Ties by index.
/// The hands, in the last places, stay there.
void CoupledSolve::orderCore() {
  const int n = coreNodes() - handsHeld();
  const auto linked = [&](int i, int j) { return graph_[static_cast<std::size_t>(i) * kMaxCore + j] != 0; };
  degree_.assign(n, 0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) degree_[i] += linked(i, j) ? 1 : 0;
  order_.clear();
  first_.assign(coreNodes(), 0);               // for the moment: whether a place has been visited
  for (int head = 0; head < n; ++head) {
    if (head == static_cast<int>(order_.size())) {
      int seed = -1;
      for (int i = 0; i < n; ++i)
        if (!first_[i] && (seed < 0 || degree_[i] < degree_[seed])) seed = i;
      order_.push_back(seed);
      first_[seed] = 1;
    }
    const std::size_t begin = order_.size();
    for (int j = 0; j < n; ++j) {
      if (first_[j] || !linked(order_[head], j)) continue;
      first_[j] = 1;
      order_.push_back(j);
      for (std::size_t k = order_.size() - 1; k > begin && degree_[order_[k]] < degree_[order_[k - 1]]; --k) std::swap(order_[k], order_[k - 1]);
    }
  }
  std::reverse(order_.begin(), order_.end());
  for (int hand = n; hand < coreNodes(); ++hand) order_.push_back(hand);
}

bool CoupledSolve::closeStructure() {
  std::sort(core_.begin(), core_.end());
  std::fill(place_.begin(), place_.end(), -1);
  const int n = coreNodes();
  for (int c = 0; c < n; ++c) place_[core_[c]] = c;
  findStretches();
  linkNeighbours();
  orderCore();
  for (int c = 0; c < n; ++c) {
    first_[c] = c;
    for (int k = c - 1; k >= 0; --k)
      if (graph_[static_cast<std::size_t>(order_[c]) * kMaxCore + order_[k]]) first_[c] = k;
  }
  for (int& place : order_) place = core_[place];
  core_.swap(order_);
  for (int c = 0; c < n; ++c) place_[core_[c]] = c;
  offset_.assign(1, 0);
  for (int c = 0; c < n; ++c) {
    const int next = offset_.back() + 3 * width(c);
    if (next > kMaxEnvelope) return false;
    offset_.push_back(next);
  }
  return true;
}

}  // namespace halsted
