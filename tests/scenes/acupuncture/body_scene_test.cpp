/// The acupuncture scene's bodies: where their points lie, and what is refused in one line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "scenes/acupuncture/body_table.h"
#include "scenes/acupuncture/ct_layers.h"
#include "scenes/acupuncture/label_volume.h"
#include "scenes/expert.h"
#include "scenes/mesh_path.h"
#include "scenes/mesh_readers/surface.h"
#include "sim/harmonics/surface.h"
#include "tests/support/process.h"
#include "tests/support/source_folder.h"

namespace halsted::scenes {
namespace {

using ::testing::HasSubstr;

std::string sceneFolder() { return halsted::testing::sourceFolder() + "/scenes/acupuncture"; }
SceneFile scene(const std::vector<std::string>& overrides = {}) { return readScene(sceneFolder(), overrides); }

Model bodyModel(const SceneFile& file) { return buildModel(file.params, buildAnatomy(file), file.procedure); }

std::string refusal(const std::function<void()>& act) {
  try { act(); } catch (const InputError& error) { return error.what(); }
  return "nothing refused";
}

TEST(AcupunctureScene, PutsTheTargetAtTheOriginFacingUp) {
  for (const char* point : {"P90", "P45"}) {
    const Model m = bodyModel(scene({std::string("anatomy.point=") + point}));
    EXPECT_EQ(m.body->targetPoint().id, point);
    EXPECT_LT(m.body->targetPlace().position.norm(), 1e-9);
    EXPECT_LT((m.body->targetPlace().normal - Vec3::UnitY()).norm(), 1e-9);
    EXPECT_EQ(tissueParticles(m), 169 + 37 + 271);   // mass points of the paper's three nets
    EXPECT_EQ(threadNodes(m), 0);
  }
}

TEST(AcupunctureScene, PointsOfTheSlabAreWhereTheirCunSay) {
  const Model m = bodyModel(scene());
  const auto place = [&](int i) { return m.body->places[i].position; };
  EXPECT_NEAR(place(1).x(), 0.8 * 25e-3, 0.1e-3);      // toward the foot: the surgeon's right
  EXPECT_NEAR(place(2).x(), -0.8 * 25e-3, 0.1e-3);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(place(i).y(), 0.0, 1e-3);
}

TEST(AcupunctureScene, RefusesInOneLineNamingFileLineAndKey) {
  EXPECT_THAT(refusal([] { scene({"needling.fat.thickness=-1e-3"}); }), HasSubstr("needling.fat.thickness"));
  EXPECT_THAT(refusal([] { buildAnatomy(scene({"anatomy.order=60"})); }), AllOf(HasSubstr("anatomy.order=60"), HasSubstr("needs at least 7442 samples")));
  EXPECT_THAT(refusal([] { buildAnatomy(scene({"anatomy.point=LU7"})); }), AllOf(HasSubstr("anatomy.point=LU7"), HasSubstr("P90, P45, P15")));
  EXPECT_THAT(refusal([] { buildAnatomy(scene({"anatomy.body=arm"})); }), AllOf(HasSubstr("anatomy.body=arm"), HasSubstr("leg, slab, torso")));
  EXPECT_THAT(refusal([] { buildAnatomy(scene({"needling.muscle.thickness=0.1", "needling.fat.thickness=0.19"})); }), HasSubstr("folds"));
  const std::string text = "title = \"t\"\n[sim]\nmodel = \"needling\"\n[anatomy]\norder = 0\n";
  EXPECT_THAT(refusal([&] { parseScene(text, "scene.toml", sceneFolder(), {}); }), HasSubstr("scene.toml:5: anatomy.order: must be 1 to 64"));
  EXPECT_THAT(refusal([&] { parseScene("title = \"t\"\n[sim]\nmodel = \"sewing\"\n", "scene.toml", sceneFolder(), {}); }),
              HasSubstr("scene.toml:3: sim.model: 'sewing' is not one of suture, needling"));
}

struct Folder : halsted::testing::TemporaryFolder {
  std::string write(const std::string& name, const std::string& text) const {
    halsted::testing::writeText(file(name), text);
    return file(name);
  }
};

TEST(AcupunctureScene, RefusesAnOpenSurface) {
  const Folder folder;
  const std::string mesh = folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  EXPECT_THAT(refusal([&] { buildAnatomy(scene({"anatomy.mesh=" + mesh, "anatomy.body=torso"})); }), AllOf(HasSubstr("open.obj"), HasSubstr("anatomy.mesh"), HasSubstr("open")));
  EXPECT_THAT(refusal([&] { buildAnatomy(scene({"anatomy.mesh=" + mesh, "anatomy.body="})); }), HasSubstr("no table of acupoints is for this surface"));
}

std::string tableRefusal(const std::string& text) {
  const Folder folder;
  const std::string path = folder.write("body.toml", text);
  return refusal([&] { readBodyTable(path); });
}

TEST(BodyTable, RefusesWhatItCannotUse) {
  const std::string head = "title = \"t\"\nfront = [0, 0, 1]\nhead = [0, 1, 0]\n";
  const std::string marks = "[[landmark]]\nat = [0, 0, 0]\ncun = 0\n[[landmark]]\nat = [0, 1, 0]\ncun = 4\n";
  EXPECT_THAT(tableRefusal(head), HasSubstr("landmark: there must be two"));
  EXPECT_THAT(tableRefusal(head + marks), HasSubstr("point: there is none"));
  EXPECT_THAT(tableRefusal(head + marks + "[[landmark]]\nat = [0, 1, 0]\ncun = 4\n"), HasSubstr("body.toml:12: landmark.cun: must rise"));
  EXPECT_THAT(tableRefusal("title = \"t\"\nfront = [0, 0, 1]\nhead = [0, 0, 2]\n"), HasSubstr("body.toml:3: head: lies along front"));
  EXPECT_THAT(tableRefusal(head + marks + "[[point]]\nid = \"A\"\nname = \"a\"\nalong_cun = 1\ndepth_mm = 20\nangle_deg = 90\n"), HasSubstr("point.source: is missing"));
  EXPECT_THAT(tableRefusal(head + marks + "[[point]]\nid = \"A\"\nname = \"a\"\nsource = \"s\"\nalong_cun = 1\ndepth_mm = -3\nangle_deg = 90\n"),
              HasSubstr("body.toml:15: point.depth_mm: must be 1 to 100, is -3"));
  EXPECT_THAT(tableRefusal(head + "colour = 3\n"), HasSubstr("body.toml:4: colour: unknown key"));
}

TEST(BodyTable, EveryShippedPointHasItsSource) {
  for (const char* name : {"slab", "torso", "leg"}) {
    const BodyTable table = readBodyTable(sceneFolder() + "/bodies/" + name + ".toml");
    EXPECT_GE(table.points.size(), 3u);
    for (const PointEntry& p : table.points) EXPECT_GT(p.source.size(), 20u) << p.id;
  }
}

TEST(NeedlingExpert, RefusesWhatTheSceneCannotDo) {
  const Model m = bodyModel(scene());
  const auto said = [&](const std::string& action) { return refusal([&] { beginExpert(parseExpert("scene = \"acupuncture\"\n[[action]]\n" + action, "e.toml"), m); }); };
  EXPECT_THAT(said("do = \"bite\""), HasSubstr("'bite' is not done in a scene of this kind"));
  EXPECT_THAT(said("do = \"insert\"\npoint = \"LU7\""), HasSubstr("no point 'LU7'"));
  EXPECT_THAT(said("do = \"insert\"\ndepth_mm = -2"), HasSubstr("e.toml:4: action.depth_mm: must be"));
  EXPECT_THAT(said("do = \"insert\"\nwidth_mm = 5"), HasSubstr("e.toml:4: action.width_mm: unknown key"));
  EXPECT_THAT(said("do = \"twirl\"\ncycles = 0"), HasSubstr("action.cycles: must be 1 to 1000"));
  EXPECT_EQ(said("do = \"insert\"\nangle_deg = 60\ndepth_mm = 12"), "nothing refused");
}

TEST(RealBodies, PointsOfTheTorsoLieOnItsFront) {
  if (dataFolder().empty()) GTEST_SKIP() << "HALSTED_DATA is not set";
  const Model m = bodyModel(scene({"anatomy.body=torso", "anatomy.point=CV12"}));
  const BodyModel& b = *m.body;
  for (const SurfaceFrame& place : b.places) EXPECT_GT(place.normal.y(), 0.6);       // faces up beside the target
  const auto along = [&](int i) { return b.places[i].position.x(); };                 // toward the feet
  EXPECT_NEAR(along(2) - along(0), (5.5 / 8.0) * 265 * 0.66e-3, 25e-3);               // CV6 below CV12
  EXPECT_LT(b.places[1].position.z(), -30e-3);                                        // ST25 to the patient's left
}

TEST(RealBodies, PointsOfTheLegLieRoundIt) {
  if (dataFolder().empty()) GTEST_SKIP() << "HALSTED_DATA is not set";
  const Model m = bodyModel(scene({"anatomy.body=leg"}));
  const BodyModel& b = *m.body;
  EXPECT_NEAR((b.places[2].position - b.places[0].position).x(), 0.26, 0.05);         // SP6, 10 cun below ST36
  EXPECT_LT(b.places[2].normal.dot(b.places[1].normal), 0.0);                         // SP6 medial, GB34 lateral
}

TEST(CtLayers, AreThoseThatTheMasksShow) {
  if (dataFolder().empty()) GTEST_SKIP() << "HALSTED_DATA is not set";
  const std::string mask = dataFolder() + "/abdomen-ct/tissue_types_slab/subcutaneous_fat.nii.gz";
  const CtLayers flank = measureLayers(mask, 60.0, "here");
  EXPECT_GT(flank.fat, 5e-3);
  EXPECT_LT(flank.fat, 25e-3);
  EXPECT_GT(flank.muscle, 5e-3);
  EXPECT_LT(flank.muscle, 25e-3);
  const Body body = buildAnatomy(scene({"anatomy.layers_from=" + mask, "anatomy.layers_angle_degrees=60"})).body;
  EXPECT_EQ(body.thickness[1], flank.fat);
  EXPECT_EQ(body.thickness[2], flank.muscle);
  EXPECT_EQ(body.thickness[0], 0.8e-3);
}

TEST(CtLayers, RefuseWhatIsNoVolume) {
  const Folder folder;
  EXPECT_THAT(refusal([&] { readLabels(folder.write("a.nii", "not a volume")); }), HasSubstr("a.nii: is cut short"));
  EXPECT_THAT(refusal([&] { readLabels(folder.write("b.nii", std::string(400, 'x'))); }), HasSubstr("b.nii: is not a NIfTI-1 file"));
  EXPECT_THAT(refusal([&] { readLabels(folder.file("none.nii")); }), HasSubstr("cannot be opened"));
}

}  // namespace
}  // namespace halsted::scenes
