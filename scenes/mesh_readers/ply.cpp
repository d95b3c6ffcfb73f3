/// PLY, text and binary little endian: x, y, z of element vertex and the index list of element face; the rest is skipped.
#include "scenes/mesh_readers/binary_input.h"
#include "scenes/mesh_readers/ply_header.h"
#include "scenes/mesh_readers/surface_builder.h"
#include "scenes/mesh_readers/text_scanner.h"

namespace halsted::scenes {
namespace {

/// One value after the other, from text or bytes.
class PlyValues {
 public:
  PlyValues(std::istream& in, const std::string& origin, bool binary) : in_(in), scan_(in, origin), binary_(binary) {}

  bool next(PlyType type, double& out) {  // [file's unit]
    if (!binary_) {
      if (!scan_.word(word_)) return false;
      out = scan_.toNumber(word_);
      return true;
    }
    switch (type) {
      case PlyType::kInt8: return as<std::int8_t>(out);
      case PlyType::kUint8: return as<std::uint8_t>(out);
      case PlyType::kInt16: return as<std::int16_t>(out);
      case PlyType::kUint16: return as<std::uint16_t>(out);
      case PlyType::kInt32: return as<std::int32_t>(out);
      case PlyType::kUint32: return as<std::uint32_t>(out);
      case PlyType::kFloat: return as<float>(out);
      default: return as<double>(out);
    }
  }

 private:
  template <typename T>
  bool as(double& out) {  // [file's unit]
    T value{};
    if (!readLittleEndian(in_, value)) return false;
    out = static_cast<double>(value);
    return true;
  }

  std::istream& in_;
  TextScanner scan_;
  bool binary_ = false;
  std::string word_;
};

struct PlyBody {
  PlyValues& values;
  SurfaceBuilder& builder;

  double value(PlyType type) {  // [file's unit]
    double out = 0.0;  // [file's unit]
    if (!values.next(type, out)) builder.fail("the file ends before its last element");
    return out;
  }

  /// A count or an index: integers only, so that 1.5 or NaN is refused.
  long long integer(PlyType type) {
    const double number = value(type);  // [1]
    if (!(number >= -1e9 && number <= 1e10) || number != static_cast<double>(static_cast<long long>(number)))
      builder.fail("a count or index is not an integer");
    return static_cast<long long>(number);
  }

  void list(const PlyProperty& property, bool isFace) {
    const long long corners = integer(property.countType);
    builder.announceTriangles(corners);
    builder.beginPolygon();
    for (long long i = 0; i < corners; ++i) {
      if (isFace) builder.addCorner(integer(property.type));
      else value(property.type);
    }
    if (isFace) builder.endPolygon();
  }

  void record(const PlyElement& element) {
    Vec3 position = Vec3::Zero();
    for (const PlyProperty& property : element.properties) {
      const bool isFace = element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
      if (property.isList) {
        list(property, isFace);
        continue;
      }
      const double number = value(property.type);  // [file's unit]
      for (int axis = 0; axis < 3; ++axis)
        if (property.name.size() == 1 && property.name[0] == 'x' + axis) position[axis] = number;
    }
    if (element.name == "vertex") builder.addVertex(position);
  }
};

}  // namespace

Surface readPly(std::istream& in, const std::string& origin, double scale) {
  const PlyHeader header = readPlyHeader(in, origin);
  std::string element;
  long long record = 0;
  SurfaceBuilder builder(scale, [&] { return origin + ": " + element + " " + std::to_string(record); });
  for (const PlyElement& announced : header.elements) {
    element = announced.name;
    if (element == "vertex") builder.announceVertices(announced.count);
    else builder.announceTriangles(announced.count);
    if (announced.properties.empty() && announced.count > 0) builder.fail("an element without properties");
  }
  PlyValues values(in, origin, header.binary);
  PlyBody body{values, builder};
  for (const PlyElement& announced : header.elements) {
    element = announced.name;
    for (record = 1; record <= announced.count; ++record) body.record(announced);
  }
  return builder.finish();
}

}  // namespace halsted::scenes
