#pragma once
/// The anatomy inside a session file, so that a recording replays without the mesh it was built from. Any thread.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/anatomy.h"

namespace halsted::app {

/// The wall, then the body, if there is one.
std::vector<std::uint8_t> encodeAnatomy(const Anatomy&);
/// False (and `error` says why) when the bytes are not a whole wall with every index in range, or a whole body of finite numbers.
bool decodeAnatomy(std::span<const std::uint8_t> bytes, Anatomy&, std::string& error);
/// FNV-1a: says whether two byte strings are the same, no more.
std::uint64_t contentHash(std::span<const std::uint8_t> bytes);

}  // namespace halsted::app
