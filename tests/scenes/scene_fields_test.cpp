/// The list of everything a scene file may set: what is set in a file or by `--set` arrives, and defaults are within their ranges.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "scenes/materials.h"
#include "scenes/scene.h"
#include "scenes/scene_fields.h"

namespace halsted {
namespace {

using scenes::SceneFile;

SceneFile parseFields(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return scenes::parseScene(text, "test.toml", "/tmp/test_scene", overrides);
}

/// A value inside the range of a field, other than its default, as TOML.
std::string sampleValue(const scenes::SceneField& field) {
  std::ostringstream number;
  number << field.min + 0.25 * (field.max - field.min);
  if (std::holds_alternative<double*>(field.slot)) return number.str();
  if (std::holds_alternative<int*>(field.slot)) return std::to_string(static_cast<int>(field.min) + 3);
  if (std::holds_alternative<std::uint64_t*>(field.slot)) return "77";
  if (std::holds_alternative<Vec3*>(field.slot)) return "[0.1, 0.2, 0.3]";
  if (std::holds_alternative<TissueSolver*>(field.slot)) return "\"xpbd\"";
  if (const auto* kind = std::get_if<ToolKind*>(&field.slot)) return **kind == ToolKind::kForceps ? "\"allis\"" : "\"forceps\"";
  if (const auto* flag = std::get_if<bool*>(&field.slot)) return **flag ? "false" : "true";
  if (std::holds_alternative<ThreadAssist*>(field.slot)) return "\"knot\"";
  if (std::holds_alternative<ModelKind*>(field.slot)) return "\"needling\"";
  if (std::holds_alternative<NetProfile*>(field.slot)) return "\"cone\"";
  if (std::holds_alternative<scenes::MaterialName>(field.slot)) return "\"fat\"";
  return "\"x\"";
}

/// What a slot holds, as `sampleValue` writes it.
struct HeldValue {
  static std::string quoted(const std::string& text) { return "\"" + text + "\""; }
  std::string operator()(const double* x) const {
    std::ostringstream number;
    number << *x;
    return number.str();
  }
  std::string operator()(const Vec3* v) const { return "[" + (*this)(&v->x()) + ", " + (*this)(&v->y()) + ", " + (*this)(&v->z()) + "]"; }
  std::string operator()(const int* x) const { return std::to_string(*x); }
  std::string operator()(const std::uint64_t* x) const { return std::to_string(*x); }
  std::string operator()(const bool* x) const { return *x ? "true" : "false"; }
  std::string operator()(const std::string* x) const { return quoted(*x); }
  std::string operator()(const ToolKind* x) const { return quoted(name(*x)); }
  std::string operator()(const TissueSolver* x) const { return quoted(*x == TissueSolver::kXpbd ? "xpbd" : "another"); }
  std::string operator()(const ThreadAssist* x) const { return quoted(*x == ThreadAssist::kKnot ? "knot" : "none"); }
  std::string operator()(const ModelKind* x) const { return quoted(*x == ModelKind::kNeedling ? "needling" : "suture"); }
  std::string operator()(const NetProfile* x) const { return quoted(*x == NetProfile::kCone ? "cone" : "another"); }
  std::string operator()(const scenes::MeshPath& x) const { return quoted(*x.path); }
  std::string operator()(const scenes::MaterialName& x) const {
    for (const scenes::Material& m : scenes::readMaterials())
      if (m.youngsModulus == x.tissue->youngsModulus && m.density == x.tissue->density) return quoted(m.name);
    return quoted("none of the list");
  }
};

/// What a parsed scene holds under a key.
std::string heldValue(SceneFile& scene, const std::string& key) {
  const std::vector<scenes::SceneField> fields = scenes::sceneFields(scene);
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const scenes::SceneField& f) { return f.key == key; });
  if (field == fields.end()) return "no such field";
  return std::visit(HeldValue{}, field->slot);
}

/// Some values only make sense together; here each is tried alone, so a refusal must at least name the key.
TEST(SceneFields, AreEachReadFromTheFileAndFromAnOverride) {
  SceneFile scratch;
  const std::vector<scenes::SceneField> fields = scenes::sceneFields(scratch);
  std::size_t found = 0;
  for (const scenes::SceneField& field : fields) {
    const std::string value = sampleValue(field), title = field.key == "title" ? "" : "title = \"t\"\n";
    for (const bool fromFile : {true, false}) {
      try {
        SceneFile parsed = fromFile ? parseFields(title + field.key + " = " + value) : parseFields("title = \"t\"\n", {field.key + "=" + value});
        EXPECT_EQ(heldValue(parsed, field.key), value) << field.key;
        ++found;
      } catch (const scenes::InputError& error) {
        EXPECT_NE(std::string(error.what()).find(field.key), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find("unknown"), std::string::npos) << error.what();
      }
    }
  }
  RecordProperty("accepted", std::to_string(found) + " of " + std::to_string(2 * fields.size()));
  EXPECT_GT(found, fields.size());             // more than every other
}

TEST(SceneFields, KeepTheirDefaultsInRange) {
  SceneFile scene;
  for (const scenes::SceneField& field : scenes::sceneFields(scene)) {
    if (const auto* number = std::get_if<double*>(&field.slot)) {
      EXPECT_GE(**number, field.min) << field.key;
      EXPECT_LE(**number, field.max) << field.key;
    }
    if (const auto* number = std::get_if<int*>(&field.slot)) {
      EXPECT_GE(**number, field.min) << field.key;
      EXPECT_LE(**number, field.max) << field.key;
    }
  }
}

}  // namespace
}  // namespace halsted
