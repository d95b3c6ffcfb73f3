#pragma once
/// The header of a PLY file: which elements follow, with which properties, in which form.
#include <istream>
#include <string>
#include <vector>

namespace halsted::scenes {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat;
  bool isList = false;
  PlyType countType = PlyType::kUint8;
};

struct PlyElement {
  std::string name;
  long long count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  bool binary = false;
  std::vector<PlyElement> elements;
  long long lines = 0;                 // header length, for messages about what follows
};

/// Leaves the stream at the first byte after the header. Throws InputError.
PlyHeader readPlyHeader(std::istream&, const std::string& origin);

}  // namespace halsted::scenes
