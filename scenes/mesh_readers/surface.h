#pragma once
/// Triangle surfaces from files: OBJ, STL (text and binary), PLY (text and binary little endian), legacy VTK polydata (text).
/// Every reader streams, keeps to the limits below, refuses what is not finite or not indexed right, and throws InputError
/// "file:line: what is wrong" ("file: face 7: ..." in binary files). No reader crashes on any bytes.
#include <array>
#include <istream>
#include <string>
#include <vector>

#include "sim/types.h"

namespace halsted::scenes {

inline constexpr std::size_t kMostTriangles = 2'000'000;
inline constexpr std::size_t kMostVertices = 2'000'000;   // text STL, which repeats every corner, may name three times as many

/// Vertices that coincide are one; triangles that had no area because of repeated corners are gone. May still be open, in several
/// pieces and non-manifold.
struct Surface {
  std::vector<Vec3> vertices;                  // [m]
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::string> groups;             // named parts; always at least one
  std::vector<int> triangleGroup;              // per triangle, index into groups
};

/// Chooses the reader by the file's extension. scale [m per unit]
Surface readSurface(const std::string& path, double scale);

/// The readers by themselves; `origin` stands for the file name in messages.
Surface readObj(std::istream&, const std::string& origin, double scale);  // scale [m per unit]
Surface readStl(std::istream&, const std::string& origin, double scale);  // scale [m per unit]
Surface readPly(std::istream&, const std::string& origin, double scale);  // scale [m per unit]
Surface readVtk(std::istream&, const std::string& origin, double scale);  // scale [m per unit]

}  // namespace halsted::scenes
