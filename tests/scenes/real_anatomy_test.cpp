/// Colons from computed tomography and from the Visible Human, as they were published. Needs HALSTED_DATA.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "scenes/scene.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

struct Source {
  const char* name;
  const char* file;
  const char* scale;     // [m per unit] as on the command line
  const char* segment;
};

/// The purse-string scene with this anatomy, as `--set` would have it.
TetMesh build(const Source& anatomy) {
  const std::string file = std::string(std::getenv("HALSTED_DATA")) + "/colon/" + anatomy.file;
  return scenes::buildAnatomy(scenes::readScene("purse_string", {"anatomy.mesh=" + file, "anatomy.scale=" + std::string(anatomy.scale),
                                                                 "anatomy.segment=" + std::string(anatomy.segment)})).mesh;
}

class RealAnatomy : public ::testing::TestWithParam<Source> {
 protected:
  void SetUp() override {
    if (!std::getenv("HALSTED_DATA")) GTEST_SKIP() << "HALSTED_DATA is not set";
  }
};

TEST_P(RealAnatomy, BecomesAWholeWall) {
  const TetMesh mesh = build(GetParam());
  testing::expectWholeWall(mesh);
  EXPECT_EQ(mesh.vertices.size(), 1224u);
  EXPECT_GT(testing::worstQuality(mesh), 0.05);
}

TEST_P(RealAnatomy, IsAsWideAsAColonAndAsThickAsItsWall) {
  const TetMesh mesh = build(GetParam());
  double radius = 0.0;  // [m]
  for (int vertex : mesh.rim) radius += mesh.vertices[vertex].norm() / static_cast<double>(mesh.rim.size());
  EXPECT_GT(radius, 10e-3);
  EXPECT_LT(radius, 35e-3);
  EXPECT_GT(testing::leastDistanceToOuterLayer(mesh), 0.5e-3);
  EXPECT_LT(testing::largestDistanceToOuterLayer(mesh), 2.1e-3);
}

/// The Altemeier scene's prolapse with the cross-section of this bowel.
TEST_P(RealAnatomy, LendsAProlapseItsCrossSection) {
  const Source& anatomy = GetParam();
  const std::string file = std::string(std::getenv("HALSTED_DATA")) + "/colon/" + anatomy.file;
  const auto scene = scenes::readScene("altemeier", {"anatomy.mesh=" + file, "anatomy.scale=" + std::string(anatomy.scale), "anatomy.segment=" + std::string(anatomy.segment)});
  const TetMesh mesh = scenes::buildAnatomy(scene).mesh, round = scenes::buildAnatomy(scenes::readScene("altemeier", {})).mesh;
  ASSERT_EQ(mesh.vertices.size(), round.vertices.size());
  EXPECT_GT(testing::worstQuality(mesh), 0.05);
  double most = 0.0;                           // [m] from the round one
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) most = std::max(most, (mesh.vertices[v] - round.vertices[v]).norm());
  std::printf("section up to %.1f mm from round\n", 1e3 * most);
  EXPECT_GT(most, 0.5e-3);
}

TEST_P(RealAnatomy, GivesTheSameBytesTwice) { EXPECT_EQ(testing::bitsOf(build(GetParam())), testing::bitsOf(build(GetParam()))); }

constexpr const char* kPatient = "patient-00020/large-intestine-DSJ-SF-.vtk";
constexpr const char* kReference = "reference-male/SBU_M_Intestine_Large.obj";

INSTANTIATE_TEST_SUITE_P(All, RealAnatomy,
                         ::testing::Values(Source{"PatientDefault", kPatient, "0.65e-3", ""},
                                           Source{"PatientStart", kPatient, "0.65e-3", "start"},
                                           Source{"PatientRange", kPatient, "0.65e-3", "0.7:0.6"},
                                           Source{"PatientDistal", "patient-00020/large-intestine-A-DSJ.vtk", "0.65e-3", ""},
                                           Source{"PatientTransverse", "patient-00020/large-intestine-SF+-HF-.vtk", "0.65e-3", ""},
                                           Source{"ReferenceDefault", kReference, "1e-3", ""},
                                           Source{"ReferenceStart", kReference, "1e-3", "start"},
                                           Source{"ReferenceEnd", kReference, "1e-3", "end"},
                                           Source{"VisibleHuman", "visible-human-male/large-intestine.vtk", "1e-3", ""}),
                         [](const auto& instance) { return std::string(instance.param.name); });

class UnusableAnatomy : public RealAnatomy {};

/// What cannot be used says why, in one line that names the file.
TEST_P(UnusableAnatomy, IsRefusedNamingTheFile) {
  testing::expectRefused([] { build(GetParam()); }, {GetParam().file, "anatomy:"});
}

INSTANTIATE_TEST_SUITE_P(All, UnusableAnatomy,
                         ::testing::Values(Source{"WrongScale", kPatient, "0.65", ""},
                                           Source{"RingOfAFlexure", "patient-00020/large-intestine-HF--HF.vtk", "0.65e-3", ""},
                                           Source{"Appendix", "patient-00020/large-intestine-AO-TA.vtk", "0.65e-3", ""},
                                           Source{"Caecum", "patient-00020/large-intestine-ICVc-AO.vtk", "0.65e-3", ""}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace halsted
