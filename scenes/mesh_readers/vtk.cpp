/// Legacy VTK polydata as text: POINTS, POLYGONS and TRIANGLE_STRIPS. Other cells and all attributes are skipped.
#include "scenes/mesh_readers/surface_builder.h"
#include "scenes/mesh_readers/text_scanner.h"

#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

void expect(TextScanner& scan, const std::string& wanted) {
  std::string word;
  if (!scan.word(word) || word != wanted) scan.fail("expected " + wanted + (word.empty() ? "" : ", found '" + quoted(word) + "'"));
}

void readHeader(TextScanner& scan) {
  const std::string magic = scan.restOfLine();
  if (magic.rfind("# vtk DataFile Version", 0) != 0) scan.fail("is not a legacy VTK file");
  if (!scan.nextLine() || !scan.nextLine()) scan.fail("the file ends in its header");
  std::string format;
  scan.word(format);
  if (format != "ASCII") scan.fail("only ASCII files are read, this one says '" + quoted(format) + "'");
  expect(scan, "DATASET");
  std::string dataset;
  scan.word(dataset);
  if (dataset != "POLYDATA") scan.fail("only POLYDATA is read, this file holds '" + quoted(dataset) + "'");
}

void readPoints(TextScanner& scan, SurfaceBuilder& builder) {
  const long long count = scan.integer();
  builder.announceVertices(count);
  std::string type;
  if (!scan.word(type)) scan.fail("POINTS without a type");
  for (long long i = 0; i < count; ++i) {
    Vec3 position;
    for (int axis = 0; axis < 3; ++axis) position[axis] = scan.number();
    builder.addVertex(position);
  }
}

/// Strips alternate their orientation from triangle to triangle.
void readStrip(TextScanner& scan, SurfaceBuilder& builder, long long corners) {
  long long a = scan.integer(), b = scan.integer();
  for (long long i = 2; i < corners; ++i) {
    const long long c = scan.integer();
    builder.beginPolygon();
    for (long long vertex : {i % 2 ? b : a, i % 2 ? a : b, c}) builder.addCorner(vertex);
    a = b;
    b = c;
  }
}

void readCells(TextScanner& scan, SurfaceBuilder& builder, bool strips) {
  const long long cells = scan.integer(), values = scan.integer();
  builder.announceTriangles(cells);
  if (values < cells) scan.fail("fewer numbers than cells; the OFFSETS form of newer files is not read");
  for (long long i = 0; i < cells; ++i) {
    const long long corners = scan.integer();
    if (corners < 3) scan.fail("a face with fewer than three corners");
    builder.announceTriangles(corners);
    if (strips) {
      readStrip(scan, builder, corners);
      continue;
    }
    builder.beginPolygon();
    for (long long k = 0; k < corners; ++k) builder.addCorner(scan.integer());
  }
}

void skipCells(TextScanner& scan, SurfaceBuilder& builder) {
  builder.announceTriangles(scan.integer());
  const long long values = scan.integer();
  for (long long i = 0; i < values; ++i) scan.integer();
}

}  // namespace

Surface readVtk(std::istream& in, const std::string& origin, double scale) {
  TextScanner scan(in, origin);
  SurfaceBuilder builder(scale, [&] { return scan.where(); });
  readHeader(scan);
  std::string keyword;
  while (scan.word(keyword)) {
    if (keyword == "POINTS") readPoints(scan, builder);
    else if (keyword == "POLYGONS") readCells(scan, builder, false);
    else if (keyword == "TRIANGLE_STRIPS") readCells(scan, builder, true);
    else if (keyword == "VERTICES" || keyword == "LINES") skipCells(scan, builder);
    else if (keyword == "POINT_DATA" || keyword == "CELL_DATA") break;
    else if (keyword == "METADATA") while (scan.nextLine() && !scan.restOfLine().empty()) continue;
    else scan.fail("unknown keyword '" + quoted(keyword) + "'");
  }
  return builder.finish();
}

}  // namespace halsted::scenes
