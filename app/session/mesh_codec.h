#pragma once
/// The anatomy inside a session file, so that a recording replays without the mesh it was built from. Any thread.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/mesh.h"

namespace halsted::app {

std::vector<std::uint8_t> encodeMesh(const TetMesh&);
/// False (and `error` says why) when the bytes are not a whole mesh with every index in range.
bool decodeMesh(std::span<const std::uint8_t> bytes, TetMesh&, std::string& error);
/// FNV-1a: says whether two byte strings are the same, no more.
std::uint64_t contentHash(std::span<const std::uint8_t> bytes);

}  // namespace halsted::app
