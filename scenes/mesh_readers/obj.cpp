/// Wavefront OBJ: v, f, o, g. Everything else is skipped.
#include "scenes/mesh_readers/surface_builder.h"
#include "scenes/mesh_readers/text_scanner.h"

namespace halsted::scenes {
namespace {

Vec3 readPosition(TextScanner& scan) {
  Vec3 position;
  std::string text;
  for (int i = 0; i < 3; ++i) {
    if (!scan.wordInLine(text)) scan.fail("v: has fewer than three coordinates");
    position[i] = scan.toNumber(text);
  }
  return position;
}

/// "7", "7/1", "7/1/3", "7//3"; counted from 1, or backwards from the last vertex when negative.
void readFace(TextScanner& scan, SurfaceBuilder& builder) {
  std::string text;
  builder.beginPolygon();
  while (scan.wordInLine(text)) {
    const long long index = scan.toInteger(text.substr(0, text.find('/')));
    if (index == 0) scan.fail("f: vertex index 0, the first vertex is 1");
    const long long vertices = static_cast<long long>(builder.vertexCount());
    if (index < -vertices) scan.fail("f: vertex index " + std::to_string(index) + " of " + std::to_string(vertices) + " vertices");
    builder.addCorner(index > 0 ? index - 1 : vertices + index);
  }
  builder.endPolygon();
}

}  // namespace

Surface readObj(std::istream& in, const std::string& origin, double scale) {
  TextScanner scan(in, origin);
  SurfaceBuilder builder(scale, [&] { return scan.where(); });
  std::string keyword;
  do {
    if (!scan.wordInLine(keyword)) continue;
    if (keyword == "v") builder.addVertex(readPosition(scan));
    else if (keyword == "f") readFace(scan, builder);
    else if (keyword == "o" || keyword == "g") builder.beginGroup(scan.restOfLine());
  } while (scan.nextLine());
  return builder.finish();
}

}  // namespace halsted::scenes
