#include "app/session/mesh_codec.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace halsted::app {
namespace {

static_assert(std::endian::native == std::endian::little, "session files are little-endian");

template <typename T>
void append(const std::vector<T>& items, std::vector<std::uint8_t>& bytes) {
  static_assert(sizeof(T) % 4 == 0);
  const std::uint64_t count = items.size();
  const auto* countBytes = reinterpret_cast<const std::uint8_t*>(&count);
  bytes.insert(bytes.end(), countBytes, countBytes + sizeof count);
  const auto* data = reinterpret_cast<const std::uint8_t*>(items.data());
  bytes.insert(bytes.end(), data, data + items.size() * sizeof(T));
}

template <typename T>
bool take(std::span<const std::uint8_t>& bytes, std::vector<T>& items) {
  std::uint64_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes = bytes.subspan(sizeof count);
  if (count > bytes.size() / sizeof(T)) return false;
  items.resize(count);
  if (count > 0) std::memcpy(static_cast<void*>(items.data()), bytes.data(), count * sizeof(T));
  bytes = bytes.subspan(count * sizeof(T));
  return true;
}

template <typename List>
bool indicesBelow(const List& list, int limit) {
  for (const auto& item : list)
    for (int index : item)
      if (index < 0 || index >= limit) return false;
  return true;
}

bool indicesBelow(const std::vector<int>& list, int limit) {
  for (int index : list)
    if (index < 0 || index >= limit) return false;
  return true;
}

}  // namespace

std::vector<std::uint8_t> encodeMesh(const TetMesh& mesh) {
  std::vector<std::uint8_t> bytes;
  append(mesh.vertices, bytes);
  append(mesh.tets, bytes);
  append(mesh.surface, bytes);
  append(mesh.triangleLayer, bytes);
  append(mesh.uv, bytes);
  append(mesh.fixed, bytes);
  append(mesh.rim, bytes);
  return bytes;
}

bool decodeMesh(std::span<const std::uint8_t> bytes, TetMesh& mesh, std::string& error) {
  const bool whole = take(bytes, mesh.vertices) && take(bytes, mesh.tets) && take(bytes, mesh.surface) &&
                     take(bytes, mesh.triangleLayer) && take(bytes, mesh.uv) && take(bytes, mesh.fixed) && take(bytes, mesh.rim);
  if (!whole || !bytes.empty()) { error = "the anatomy is cut short"; return false; }
  const int count = static_cast<int>(mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices)
    if (!vertex.allFinite()) { error = "the anatomy has a vertex that is not finite"; return false; }
  const bool consistent = mesh.uv.size() == mesh.vertices.size() && mesh.triangleLayer.size() == mesh.surface.size();
  const bool inRange = indicesBelow(mesh.tets, count) && indicesBelow(mesh.surface, count) && indicesBelow(mesh.fixed, count) &&
                       indicesBelow(mesh.rim, count) && indicesBelow(mesh.triangleLayer, 3);
  if (!consistent || !inRange) { error = "the anatomy refers to vertices that it does not have"; return false; }
  return true;
}

std::uint64_t contentHash(std::span<const std::uint8_t> bytes) {
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (std::uint8_t byte : bytes) sum = (sum ^ byte) * 0x100000001b3ULL;
  return sum;
}

}  // namespace halsted::app
