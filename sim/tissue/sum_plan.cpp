#include <algorithm>
#include <array>

#include "sim/tissue/shape_matching_model.h"

namespace halsted {
namespace {

using Pair = std::array<int, 2>;

constexpr int kWorth = 4;                      // [1] lists that must share a sum: it has to be stored and read again

/// Pairs that stand together in many lists, most first, no node in two of them.
std::vector<Pair> commonPairs(const std::vector<std::vector<int>>& lists, int nodes) {
  std::vector<Pair> all;
  for (const auto& list : lists)
    for (std::size_t i = 0; i < list.size(); ++i)
      for (std::size_t k = i + 1; k < list.size(); ++k) all.push_back({list[i], list[k]});
  std::sort(all.begin(), all.end());
  std::vector<std::array<int, 3>> counted;     // minus the count, then the pair
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::upper_bound(first, all.end(), *first);
    if (last - first >= kWorth) counted.push_back({-static_cast<int>(last - first), (*first)[0], (*first)[1]});
    first = last;
  }
  std::sort(counted.begin(), counted.end());
  std::vector<char> taken(static_cast<std::size_t>(nodes), 0);
  std::vector<Pair> chosen;
  for (const auto& [count, a, b] : counted) {
    if (taken[a] || taken[b]) continue;
    taken[a] = taken[b] = 1;
    chosen.push_back({a, b});
  }
  std::sort(chosen.begin(), chosen.end());     // memory is read in order
  return chosen;
}

/// Puts node `first + k` into every list in place of both nodes of pair k. Lists stay ascending.
void replacePairs(const std::vector<Pair>& pairs, int first, std::vector<std::vector<int>>& lists) {
  std::vector<int> partner(static_cast<std::size_t>(first), -1), sum(static_cast<std::size_t>(first), -1);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    partner[pairs[k][0]] = pairs[k][1];
    partner[pairs[k][1]] = pairs[k][0];
    sum[pairs[k][0]] = first + static_cast<int>(k);                    // once, for the first of the two
  }
  for (auto& list : lists) {
    std::vector<int> kept, fresh;
    for (int node : list) {
      if (partner[node] < 0 || !std::binary_search(list.begin(), list.end(), partner[node])) kept.push_back(node);
      else if (sum[node] >= 0) fresh.push_back(sum[node]);
    }
    std::sort(fresh.begin(), fresh.end());
    kept.insert(kept.end(), fresh.begin(), fresh.end());
    list = std::move(kept);
  }
}

}  // namespace

SumPlan planSums(std::vector<std::vector<int>> lists, int inputs) {
  constexpr int kMap = ShapeMatchingModel::kMap;
  SumPlan plan;
  for (int nodes = inputs;;) {
    const std::vector<Pair> pairs = commonPairs(lists, nodes);
    if (pairs.empty()) break;
    replacePairs(pairs, nodes, lists);
    for (const Pair& pair : pairs)
      for (int node : pair) plan.shared.push_back(kMap * node);
    nodes += static_cast<int>(pairs.size());
  }
  const int empty = inputs + static_cast<int>(plan.shared.size()) / 2;
  plan.start.assign(1, 0);
  for (std::size_t first = 0; first < lists.size(); first += SumPlan::kLists) {
    std::size_t longest = 0;
    for (std::size_t l = first; l < std::min(first + SumPlan::kLists, lists.size()); ++l) longest = std::max(longest, lists[l].size());
    for (std::size_t k = 0; k < longest; ++k) {
      for (std::size_t l = 0; l < SumPlan::kLists; ++l) {
        const std::vector<int>& list = lists[std::min(first + l, lists.size() - 1)];
        plan.node.push_back(kMap * (k < list.size() ? list[k] : empty));
      }
    }
    plan.start.push_back(static_cast<int>(plan.node.size()));
  }
  return plan;
}

}  // namespace halsted
