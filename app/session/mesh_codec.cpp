#include "app/session/mesh_codec.h"

#include <algorithm>
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

void encodeMesh(const TetMesh& mesh, std::vector<std::uint8_t>& bytes) {
  append(mesh.vertices, bytes);
  append(mesh.tets, bytes);
  append(mesh.surface, bytes);
  append(mesh.triangleLayer, bytes);
  append(mesh.uv, bytes);
  append(mesh.fixed, bytes);
  append(mesh.rim, bytes);
}

bool decodeMesh(std::span<const std::uint8_t>& bytes, TetMesh& mesh, std::string& error) {
  const bool whole = take(bytes, mesh.vertices) && take(bytes, mesh.tets) && take(bytes, mesh.surface) &&
                     take(bytes, mesh.triangleLayer) && take(bytes, mesh.uv) && take(bytes, mesh.fixed) && take(bytes, mesh.rim);
  if (!whole) { error = "the anatomy is cut short"; return false; }
  const int count = static_cast<int>(mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices)
    if (!vertex.allFinite()) { error = "the anatomy has a vertex that is not finite"; return false; }
  const bool consistent = mesh.uv.size() == mesh.vertices.size() && mesh.triangleLayer.size() == mesh.surface.size();
  const bool inRange = indicesBelow(mesh.tets, count) && indicesBelow(mesh.surface, count) && indicesBelow(mesh.fixed, count) &&
                       indicesBelow(mesh.rim, count) && indicesBelow(mesh.triangleLayer, 3);
  if (!consistent || !inRange) { error = "the anatomy refers to vertices that it does not have"; return false; }
  return true;
}

/// Of a wall that can be cut.
void encodeCut(const TetMesh& mesh, std::vector<std::uint8_t>& bytes) {
  append(std::vector<int>(mesh.cuttable.begin(), mesh.cuttable.end()), bytes);
  append(mesh.cutLine, bytes);
  append(mesh.bowel, bytes);
}

bool takeCut(std::span<const std::uint8_t>& bytes, TetMesh& mesh) {
  std::vector<int> cuttable;
  if (!take(bytes, cuttable) || !take(bytes, mesh.cutLine) || !take(bytes, mesh.bowel) || !indicesBelow(cuttable, 2)) return false;
  mesh.cuttable.assign(cuttable.begin(), cuttable.end());
  for (const CutMark& mark : mesh.cutLine)
    if (!std::isfinite(mark.fromLine)) return false;
  if (!(mesh.bowel.empty() || (mesh.bowel.size() == mesh.vertices.size() && indicesBelow(mesh.bowel, kCutWalls)))) return false;
  return mesh.cuttable.size() == mesh.tets.size() && (mesh.cutLine.empty() || mesh.cutLine.size() == mesh.tets.size());
}

/// A text as one number a letter: few and short.
std::vector<int> letters(const std::string& text) { return {text.begin(), text.end()}; }
bool takeText(std::span<const std::uint8_t>& bytes, std::string& text) {
  std::vector<int> codes;
  if (!take(bytes, codes)) return false;
  for (int code : codes) text += static_cast<char>(code);
  return true;
}

void encodeBody(const Body& body, std::vector<std::uint8_t>& bytes) {
  append(std::vector<int>{body.order, body.target, static_cast<int>(body.points.size())}, bytes);
  for (const auto& surface : body.surface) append(surface, bytes);
  append(std::vector<double>(body.thickness.begin(), body.thickness.end()), bytes);   // [m]
  for (const Acupoint& point : body.points) {
    append(letters(point.id), bytes);
    append(letters(point.name), bytes);
    append(std::vector<Vec3>{point.unit, point.lean}, bytes);
    append(std::vector<double>{point.depth, point.angle}, bytes);   // [m], [rad]
  }
}

bool finite(const std::vector<double>& values) {   // any unit
  for (double value : values)
    if (!std::isfinite(value)) return false;
  return true;
}

bool takePoint(std::span<const std::uint8_t>& bytes, Acupoint& point) {
  std::vector<Vec3> ways;                      // [1]
  std::vector<double> numbers;                 // [m], [rad]
  if (!takeText(bytes, point.id) || !takeText(bytes, point.name) || !take(bytes, ways) || !take(bytes, numbers)) return false;
  if (ways.size() != 2 || numbers.size() != 2 || !finite(numbers) || !ways[0].allFinite() || !ways[1].allFinite()) return false;
  point.unit = ways[0];
  point.lean = ways[1];
  point.depth = numbers[0];
  point.angle = numbers[1];
  const double size = point.unit.squaredNorm();   // [1]
  return size > 0.99 && size < 1.01;
}

bool takeBody(std::span<const std::uint8_t>& bytes, Body& body) {
  constexpr int kMostPoints = 1000, kHighestOrder = 64;
  std::vector<int> counts;
  if (!take(bytes, counts) || counts.size() != 3 || counts[0] < 1 || counts[0] > kHighestOrder || counts[2] < 1 || counts[2] > kMostPoints) return false;
  body.order = counts[0];
  body.target = counts[1];
  for (auto& surface : body.surface) {
    if (!take(bytes, surface) || surface.size() != static_cast<std::size_t>((body.order + 1) * (body.order + 1))) return false;
    for (const Vec3& c : surface)
      if (!c.allFinite()) return false;
  }
  std::vector<double> thickness;               // [m]
  if (!take(bytes, thickness) || thickness.size() != body.thickness.size() || !finite(thickness)) return false;
  std::copy(thickness.begin(), thickness.end(), body.thickness.begin());
  body.points.resize(counts[2]);
  for (Acupoint& point : body.points)
    if (!takePoint(bytes, point)) return false;
  return body.target >= 0 && body.target < counts[2];
}

}  // namespace

std::vector<std::uint8_t> encodeAnatomy(const Anatomy& anatomy) {
  std::vector<std::uint8_t> bytes;
  encodeMesh(anatomy.mesh, bytes);
  if (!anatomy.mesh.cuttable.empty()) encodeCut(anatomy.mesh, bytes);
  if (!anatomy.body.empty()) encodeBody(anatomy.body, bytes);
  return bytes;
}

bool decodeAnatomy(std::span<const std::uint8_t> bytes, Anatomy& anatomy, std::string& error) {
  if (!decodeMesh(bytes, anatomy.mesh, error)) return false;
  if (bytes.empty()) return true;
  if ((anatomy.mesh.vertices.empty() ? takeBody(bytes, anatomy.body) : takeCut(bytes, anatomy.mesh)) && bytes.empty()) return true;
  error = anatomy.mesh.vertices.empty() ? "the body is not whole" : "the anatomy is longer than its wall";
  return false;
}

std::uint64_t contentHash(std::span<const std::uint8_t> bytes) {
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (std::uint8_t byte : bytes) sum = (sum ^ byte) * 0x100000001b3ULL;
  return sum;
}

}  // namespace halsted::app
