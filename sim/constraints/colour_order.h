#pragma once
/// Sets of particles in colours: those of a colour share no particle, so they can be projected in any order, or at once. Greedy: each takes the first
/// colour that none of its particles has yet; the colours depend on the list alone. At load time. The tets of sim/tissue's XPBD solver are coloured so.
#include <array>
#include <cstddef>
#include <vector>

namespace halsted {

template <std::size_t N> std::vector<int> colours(const std::vector<std::array<int, N>>& particles);

/// Indices by colour, then index.
template <std::size_t N> std::vector<int> colourOrder(const std::vector<std::array<int, N>>& particles);

}  // namespace halsted
