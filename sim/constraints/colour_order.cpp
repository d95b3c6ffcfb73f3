#include "sim/constraints/colour_order.h"

#include <algorithm>

namespace halsted {
namespace {

/// The first colour that none of the particles has yet; marks it as taken by all of them.
template <std::size_t N> int takeColour(const std::array<int, N>& particles, std::vector<std::vector<char>>& taken) {
  const auto isTaken = [&](std::size_t colour) {
    return std::any_of(particles.begin(), particles.end(), [&](int p) { return colour < taken[p].size() && taken[p][colour]; });
  };
  std::size_t colour = 0;
  while (isTaken(colour)) ++colour;
  for (int p : particles) {
    if (taken[p].size() <= colour) taken[p].resize(colour + 1, 0);
    taken[p][colour] = 1;
  }
  return static_cast<int>(colour);
}

}  // namespace

template <std::size_t N> std::vector<int> colours(const std::vector<std::array<int, N>>& particles) {
  int last = -1;
  for (const auto& list : particles)
    for (int p : list) last = std::max(last, p);
  std::vector<std::vector<char>> taken(last + 1);
  std::vector<int> colour;
  for (const auto& list : particles) colour.push_back(takeColour(list, taken));
  return colour;
}

template <std::size_t N> std::vector<int> colourOrder(const std::vector<std::array<int, N>>& particles) {
  const std::vector<int> colour = colours(particles);
  std::vector<int> order;
  for (std::size_t c = 0; c < particles.size(); ++c) order.push_back(static_cast<int>(c));
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return colour[a] < colour[b]; });
  return order;
}

template std::vector<int> colours(const std::vector<std::array<int, 4>>&);
template std::vector<int> colourOrder(const std::vector<std::array<int, 2>>&);
template std::vector<int> colourOrder(const std::vector<std::array<int, 4>>&);

}  // namespace halsted
