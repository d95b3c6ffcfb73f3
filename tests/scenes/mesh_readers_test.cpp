/// Surface files of every kind: what is read back is what was written, and bad files are refused in one line.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include "scenes/mesh_readers/surface.h"
#include "scenes/scene.h"
#include "tests/scenes/surface_makers.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

using scenes::Surface;
using testing::expectRefused;

struct Format {
  const char* name;
  std::string (*write)(const Surface&);
  Surface (*read)(std::istream&, const std::string&, double);
  double precision;  // [1] relative, of one coordinate
};

class MeshReaders : public ::testing::TestWithParam<Format> {};

Surface readText(const Format& format, const std::string& text, double scale = 1.0) {  // [m per unit]
  std::istringstream in(text);
  return format.read(in, "test.mesh", scale);
}

TEST_P(MeshReaders, ReadBackWhatWasWritten) {
  const Surface wrote = testing::tubeSurface({});
  const Surface read = readText(GetParam(), GetParam().write(wrote));
  ASSERT_EQ(read.triangles.size(), wrote.triangles.size());
  EXPECT_EQ(read.vertices.size(), wrote.vertices.size()) << "corners are welded";
  for (std::size_t t = 0; t < wrote.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3 error = read.vertices[read.triangles[t][k]] - wrote.vertices[wrote.triangles[t][k]];
      EXPECT_LT(error.norm(), GetParam().precision);
    }
}

TEST_P(MeshReaders, Scale) {
  const Surface wrote = testing::tubeSurface({});
  const Surface read = readText(GetParam(), GetParam().write(wrote), 0.5);
  const Vec3 error = read.vertices[read.triangles[0][0]] - 0.5 * wrote.vertices[wrote.triangles[0][0]];
  EXPECT_LT(error.norm(), GetParam().precision);
}

TEST_P(MeshReaders, RefuseNothing) { expectRefused([&] { readText(GetParam(), ""); }, {"test.mesh"}); }

TEST_P(MeshReaders, RefuseASurfaceWithoutTriangles) {
  Surface empty;
  empty.groups = {"empty"};
  expectRefused([&] { readText(GetParam(), GetParam().write(empty)); }, {"test.mesh", "no triangles"});
}

TEST_P(MeshReaders, RefuseCoordinatesThatAreNotFinite) {
  for (double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {  // [m]
    Surface surface = testing::tubeSurface({});
    surface.vertices[7].y() = bad;
    expectRefused([&] { readText(GetParam(), GetParam().write(surface)); }, {"test.mesh", "not a finite number"});
  }
}

TEST_P(MeshReaders, RefuseCoordinatesFarFromAnyBody) {
  expectRefused([&] { readText(GetParam(), GetParam().write(testing::tubeSurface({})), 1e9); }, {"at this scale"});
}

TEST_P(MeshReaders, SurviveEveryTruncation) {
  testing::TubeShape small;
  small.around = 4;
  small.rows = 3;
  const std::string whole = GetParam().write(testing::tubeSurface(small));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    try {
      readText(GetParam(), whole.substr(0, length));
    } catch (const scenes::InputError& error) {
      EXPECT_NE(std::string(error.what()).find("test.mesh"), std::string::npos);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, MeshReaders,
                         ::testing::Values(Format{"Obj", testing::asObj, scenes::readObj, 1e-12},
                                           Format{"TextStl", testing::asTextStl, scenes::readStl, 1e-12},
                                           Format{"BinaryStl", testing::asBinaryStl, scenes::readStl, 1e-6},
                                           Format{"TextPly", testing::asTextPly, scenes::readPly, 1e-12},
                                           Format{"BinaryPly", testing::asBinaryPly, scenes::readPly, 1e-12},
                                           Format{"Vtk", testing::asVtk, scenes::readVtk, 1e-12}),
                         [](const auto& instance) { return std::string(instance.param.name); });

struct BadFile {
  const char* extension;
  const char* text;
  const char* message;
};

class BadMeshFiles : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadMeshFiles, AreRefusedNamingFileAndLine) {
  const std::string path = testing::freshFolder("mesh") + "/bad" + GetParam().extension;
  testing::writeFile(path, GetParam().text);
  expectRefused([&] { scenes::readSurface(path, 1.0); }, {"bad" + std::string(GetParam().extension), GetParam().message});
}

constexpr const char* kVtkHead = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n";

INSTANTIATE_TEST_SUITE_P(
    All, BadMeshFiles,
    ::testing::Values(
        BadFile{".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", ".obj:4: vertex index out of range"},
        BadFile{".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", ".obj:4: f: vertex index 0"},
        BadFile{".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", ".obj:4: f: vertex index -4"},
        BadFile{".obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", ".obj:3: a face with fewer than three corners"},
        BadFile{".obj", "v 0 zero 0\n", ".obj:1: 'zero' is not a number"},
        BadFile{".obj", "v 0 0\n", ".obj:1: v: has fewer than three coordinates"},
        BadFile{".obj", "v 0 0 1e999\n", ".obj:1: '1e999' is too large"},
        BadFile{".obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n", "no triangles with an area"},
        BadFile{".stl", "solid x\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n", ".stl:6: a facet without three corners"},
        BadFile{".stl", "solid x\nvertex 0 0 0\n", ".stl:2: a vertex outside a loop"},
        BadFile{".stl", "neither text nor binary, but long enough to hold the eighty bytes of a header and a number of triangles",
                "triangles but holds"},
        BadFile{".ply", "ply\nformat binary_big_endian 1.0\nend_header\n", ".ply:2: format 'binary_big_endian' is not read"},
        BadFile{".ply", "ply\nformat ascii 1.0\nelement vertex 10000000\nproperty float x\nend_header\n", "too many vertices: 10000000"},
        BadFile{".ply", "ply\nformat ascii 1.0\nelement face 10000000\nproperty list uchar int vertex_index\nend_header\n",
                "too many triangles: 10000000"},
        BadFile{".ply", "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n", ".ply:3: '-1' is not a count"},
        BadFile{".ply", "ply\nformat ascii 1.0\nelement vertex 3\nend_header\n", "without properties"},
        BadFile{".ply", "ply\nend_header\n", "names no format"},
        BadFile{".vtk", "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\n", ".vtk:3: only ASCII files are read"},
        BadFile{".vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n", ".vtk:4: only POLYDATA is read"},
        BadFile{".vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 10000000 float\n", "too many vertices: 10000000"},
        BadFile{".vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0\n", "the file ends where a number"},
        BadFile{".vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOLYGONS 10000000 4\n", "too many triangles: 10000000"},
        BadFile{".vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nSPHERES 3\n", ".vtk:5: unknown keyword 'SPHERES'"},
        BadFile{".gltf", "{}", "unknown kind of mesh file"}));

TEST(MeshReader, RefusesTenMillionTrianglesWithoutReadingThemAll) {
  const std::string path = testing::freshFolder("mesh") + "/huge.stl";
  std::string bytes(80, ' ');
  const std::uint32_t count = 10'000'000;
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  testing::writeFile(path, bytes);
  std::filesystem::resize_file(path, 84 + 50ULL * count);  // sparse: takes no room on the disk
  expectRefused([&] { scenes::readSurface(path, 1.0); }, {"huge.stl", "too many triangles: 10000000", "2 million"});
}

TEST(MeshReader, RefusesAnObjOfTooManyTrianglesAsSoonAsItMeetsThem) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  for (int i = 0; i < 2'000'010; ++i) text += " 1 2 3";
  std::istringstream in(text);
  expectRefused([&] { scenes::readObj(in, "many.obj", 1.0); }, {"many.obj:4", "too many triangles"});
  EXPECT_LT(in.tellg(), static_cast<std::streamoff>(text.size()));
}

TEST(MeshReader, SplitsPolygonsAndStrips) {
  std::istringstream quad("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n");
  EXPECT_EQ(scenes::readObj(quad, "quad.obj", 1.0).triangles.size(), 2u);
  std::istringstream strip(std::string(kVtkHead) + "POINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\n");
  const Surface surface = scenes::readVtk(strip, "strip.vtk", 1.0);
  ASSERT_EQ(surface.triangles.size(), 2u);
  for (const auto& [a, b, c] : surface.triangles)
    EXPECT_GT((surface.vertices[b] - surface.vertices[a]).cross(surface.vertices[c] - surface.vertices[a]).z(), 0.0);
}

TEST(MeshReader, KeepsTheNamesOfParts) {
  std::istringstream in("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no inner wall\nf 1 2 3\ng outer\nf 1 2 4\n");
  const Surface surface = scenes::readObj(in, "parts.obj", 1.0);
  EXPECT_EQ(surface.groups[surface.triangleGroup[0]], "inner wall");
  EXPECT_EQ(surface.groups[surface.triangleGroup[1]], "outer");
}

TEST(MeshReader, RefusesAFolderAndAMissingFile) {
  expectRefused([] { scenes::readSurface("/nowhere/colon.obj", 1.0); }, {"/nowhere/colon.obj", "no such file"});
  expectRefused([] { scenes::readSurface(::testing::TempDir(), 1.0); }, {"no such file"});
}

}  // namespace
}  // namespace halsted
