/// STL, text and binary. Both repeat every corner; welding makes a surface of the triangles.
#include "scenes/mesh_readers/binary_input.h"
#include "scenes/mesh_readers/surface_builder.h"
#include "scenes/mesh_readers/text_scanner.h"

namespace halsted::scenes {
namespace {

constexpr long long kHeaderBytes = 80, kRecordBytes = 50;

void readBinaryTriangle(std::istream& in, SurfaceBuilder& builder) {
  float values[12];  // [mesh units] normal, then three corners
  std::uint16_t attribute = 0;
  bool whole = true;
  for (float& value : values) whole = whole && readLittleEndian(in, value);
  if (!whole || !readLittleEndian(in, attribute)) builder.fail("the file ends inside a triangle");
  builder.beginPolygon();
  for (int corner = 1; corner <= 3; ++corner) {
    builder.addVertex(Vec3(values[3 * corner], values[3 * corner + 1], values[3 * corner + 2]));
    builder.addCorner(static_cast<long long>(builder.vertexCount()) - 1);
  }
}

Surface readBinary(std::istream& in, const std::string& origin, double scale, std::uint32_t count) {
  std::uint32_t triangle = 0;
  SurfaceBuilder builder(scale, [&] { return origin + ": triangle " + std::to_string(triangle); });
  builder.limitVertices(3 * kMostTriangles);
  builder.announceTriangles(count);
  for (triangle = 1; triangle <= count; ++triangle) readBinaryTriangle(in, builder);
  return builder.finish();
}

Surface readText(std::istream& in, const std::string& origin, double scale) {
  TextScanner scan(in, origin);
  SurfaceBuilder builder(scale, [&] { return scan.where(); });
  builder.limitVertices(3 * kMostTriangles);
  std::string word;
  int corners = -1;  // of the open loop; -1 outside one
  while (scan.wordInLine(word) || scan.nextLine()) {
    if (word == "outer") {
      builder.beginPolygon();
      corners = 0;
    } else if (word == "vertex") {
      if (corners < 0) scan.fail("a vertex outside a loop");
      if (++corners > 3) scan.fail("a facet with more than three corners");
      Vec3 position;
      for (int i = 0; i < 3; ++i) position[i] = scan.number();
      builder.addVertex(position);
      builder.addCorner(static_cast<long long>(builder.vertexCount()) - 1);
    } else if (word == "endloop") {
      if (corners != 3) scan.fail("a facet without three corners");
      corners = -1;
    } else if (word == "solid" || word == "endsolid") {
      scan.restOfLine();  // a name may be any word
    }
    word.clear();
  }
  if (corners >= 0) scan.fail("the file ends inside a facet");
  return builder.finish();
}

long long remainingBytes(std::istream& in) {
  const auto here = in.tellg();
  in.seekg(0, std::ios::end);
  const auto end = in.tellg();
  in.seekg(here);
  return end - here;
}

}  // namespace

/// A binary file says its own length; the word "solid" at the start proves nothing, since binary headers carry it too.
Surface readStl(std::istream& in, const std::string& origin, double scale) {
  const long long bytes = remainingBytes(in);
  char header[kHeaderBytes];
  std::uint32_t count = 0;
  const bool hasCount = in.read(header, kHeaderBytes) && readLittleEndian(in, count);
  if (hasCount && bytes == kHeaderBytes + 4 + kRecordBytes * static_cast<long long>(count))
    return readBinary(in, origin, scale, count);
  in.clear();
  in.seekg(0);
  char start[5] = {};
  in.read(start, 5);
  const bool text = in.gcount() == 5 && std::string(start, 5) == "solid";
  in.clear();
  in.seekg(0);
  if (text) return readText(in, origin, scale);
  if (!hasCount) throw InputError(origin + ": is empty or not an STL file");
  throw InputError(origin + ": says " + std::to_string(count) + " triangles but holds " + std::to_string(bytes) + " bytes");
}

}  // namespace halsted::scenes
