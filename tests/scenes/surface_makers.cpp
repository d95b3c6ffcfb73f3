#include "tests/scenes/surface_makers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace halsted::testing {
namespace {

constexpr double kTwoPi = 6.28318530717958648;  // [1]

/// Middle line: straight along z, or a circle in the y-z plane.
Vec3 tubePoint(const TubeShape& shape, double angle, double along) {  // angle [rad], along [m]
  const Vec3 spoke(std::cos(angle), std::sin(angle), 0.0);
  if (shape.bendRadius == 0.0) return shape.radius * spoke + Vec3(0, 0, along);
  const double turn = along / shape.bendRadius;  // [rad]
  const double reach = shape.bendRadius + shape.radius * spoke.y();  // [m]
  return Vec3(shape.radius * spoke.x(), reach * std::cos(turn), reach * std::sin(turn));
}

/// Closes a grid of rows x around into triangles, outward when columns run counter-clockwise seen from the last row.
void addGrid(int rows, int around, int first, scenes::Surface& surface) {
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column < around; ++column) {
      const int a = first + row * around + column, b = first + row * around + (column + 1) % around;
      surface.triangles.push_back({a, b, b + around});
      surface.triangles.push_back({a, b + around, a + around});
    }
  surface.triangleGroup.resize(surface.triangles.size(), 0);
}

template <typename T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);  // tests run on little-endian x86-64
}

std::ostringstream exactText() {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  return out;
}

}  // namespace

scenes::Surface tubeSurface(const TubeShape& shape) {
  scenes::Surface surface;
  surface.groups = {"tube"};
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.around; ++column)
      surface.vertices.push_back(tubePoint(shape, kTwoPi * column / shape.around, shape.length * row / (shape.rows - 1)));
  addGrid(shape.rows, shape.around, 0, surface);
  return surface;
}

scenes::Surface doubleTube(const TubeShape& shape, double wall) {
  scenes::Surface surface = tubeSurface(shape);
  TubeShape inner = shape;
  inner.radius -= wall;
  const scenes::Surface lining = tubeSurface(inner);
  const int first = static_cast<int>(surface.vertices.size());
  surface.vertices.insert(surface.vertices.end(), lining.vertices.begin(), lining.vertices.end());
  addGrid(shape.rows, shape.around, first, surface);
  return surface;
}

scenes::Surface sphereSurface(double radius) {
  TubeShape shape;
  scenes::Surface surface = tubeSurface(shape);
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.around; ++column) {
      const double polar = 0.5 * kTwoPi * (0.02 + 0.96 * row / (shape.rows - 1)), angle = kTwoPi * column / shape.around;  // [rad]
      surface.vertices[row * shape.around + column] =
          radius * Vec3(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), -std::cos(polar));
    }
  return surface;
}

scenes::Surface planeSurface(double size) {
  constexpr int kCells = 30;
  scenes::Surface surface;
  surface.groups = {"plane"};
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j) surface.vertices.emplace_back(size * j / kCells, size * i / kCells, 0.0);
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const int a = i * (kCells + 1) + j;
      surface.triangles.push_back({a, a + 1, a + kCells + 2});
      surface.triangles.push_back({a, a + kCells + 2, a + kCells + 1});
    }
  surface.triangleGroup.resize(surface.triangles.size(), 0);
  return surface;
}

scenes::Surface without(const scenes::Surface& surface, const std::function<bool(const Vec3&)>& drop) {
  scenes::Surface rest = surface;
  rest.triangles.clear();
  for (const auto& [a, b, c] : surface.triangles)
    if (!drop((surface.vertices[a] + surface.vertices[b] + surface.vertices[c]) / 3.0)) rest.triangles.push_back({a, b, c});
  rest.triangleGroup.assign(rest.triangles.size(), 0);
  return rest;
}

std::string asObj(const scenes::Surface& surface) {
  std::ostringstream out = exactText();
  out << "# made for a test\no " << surface.groups[0] << "\n";
  for (const Vec3& v : surface.vertices) out << "v " << v.x() << " " << v.y() << " " << v.z() << "\n";
  for (const auto& t : surface.triangles) out << "f " << t[0] + 1 << "/1/1 " << t[1] + 1 << "//2 " << t[2] + 1 << "\n";
  return out.str();
}

std::string asTextStl(const scenes::Surface& surface) {
  std::ostringstream out = exactText();
  out << "solid made for a test\n";
  for (const auto& t : surface.triangles) {
    out << "facet normal 0 0 0\n outer loop\n";
    for (int corner : t) out << "  vertex " << surface.vertices[corner].transpose() << "\n";
    out << " endloop\nendfacet\n";
  }
  out << "endsolid made for a test\n";
  return out.str();
}

std::string asBinaryStl(const scenes::Surface& surface) {
  std::string bytes = "solid, although binary";
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(surface.triangles.size()));
  for (const auto& t : surface.triangles) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0f);
    for (int corner : t)
      for (int i = 0; i < 3; ++i) append(bytes, static_cast<float>(surface.vertices[corner][i]));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string asTextPly(const scenes::Surface& surface) {
  std::ostringstream out = exactText();
  out << "ply\nformat ascii 1.0\ncomment made for a test\nelement vertex " << surface.vertices.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nelement face " << surface.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& v : surface.vertices) out << v.transpose() << " 255\n";
  for (const auto& t : surface.triangles) out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  return out.str();
}

std::string asBinaryPly(const scenes::Surface& surface) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(surface.vertices.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nproperty float quality\nelement face " +
                      std::to_string(surface.triangles.size()) + "\nproperty uchar flags\nproperty list uchar uint vertex_index\nend_header\n";
  for (const Vec3& v : surface.vertices) {
    for (int i = 0; i < 3; ++i) append(bytes, v[i]);
    append(bytes, 1.0f);
  }
  for (const auto& t : surface.triangles) {
    append(bytes, std::uint8_t{0});
    append(bytes, std::uint8_t{3});
    for (int corner : t) append(bytes, static_cast<std::uint32_t>(corner));
  }
  return bytes;
}

std::string asVtk(const scenes::Surface& surface) {
  std::ostringstream out = exactText();
  out << "# vtk DataFile Version 1.0\nmade for a test\nASCII\nDATASET POLYDATA\nPOINTS " << surface.vertices.size() << " float\n";
  for (const Vec3& v : surface.vertices) out << v.transpose() << "\n";
  out << "POLYGONS " << surface.triangles.size() << " " << 4 * surface.triangles.size() << "\n";
  for (const auto& t : surface.triangles) out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  return out.str();
}

std::string freshFolder(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string unique = std::string("halsted_") + test->test_suite_name() + "_" + test->name() + "_" + name;
  for (char& c : unique)
    if (c == '/') c = '_';
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / unique;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

void writeFile(const std::string& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  ASSERT_TRUE(out.good()) << path;
}

}  // namespace halsted::testing
