#include "app/parameters.h"

#include <cstdio>

#include "scenes/scene_fields.h"

namespace halsted::app {
namespace {

std::string decimal(double value) {            // any unit
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.17g", value);
  const std::string text = digits;
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

/// A mesh or a material names a file: what came of it is stored instead, the anatomy whole, a material as its numbers.
struct Printer {
  std::string operator()(const double* value) const { return decimal(*value); }
  std::string operator()(const int* value) const { return std::to_string(*value); }
  std::string operator()(const std::uint64_t* value) const { return std::to_string(*value); }
  std::string operator()(const Vec3* v) const { return "[" + decimal(v->x()) + ", " + decimal(v->y()) + ", " + decimal(v->z()) + "]"; }
  std::string operator()(const TissueSolver* solver) const {
    const char* names[] = {"projective", "xpbd", "shape_matching"};
    return names[static_cast<int>(*solver)];
  }
  std::string operator()(const ThreadAssist* assist) const { return *assist == ThreadAssist::kKnot ? "knot" : "none"; }
  std::string operator()(const ToolKind* kind) const { return name(*kind); }
  std::string operator()(const ModelKind* kind) const { return *kind == ModelKind::kSuture ? "suture" : "needling"; }
  std::string operator()(const NetProfile* profile) const { return *profile == NetProfile::kCone ? "cone" : "inverse_distance"; }
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const std::string* text) const { return "\"" + *text + "\""; }
  std::string operator()(const scenes::MaterialName&) const { return {}; }
  std::string operator()(const scenes::MeshPath&) const { return {}; }
};

}  // namespace

std::vector<std::string> resolvedParameters(const scenes::SceneFile& given) {
  scenes::SceneFile scene = given;             // the field list points into a scene that it may write
  std::vector<std::string> lines;
  for (const scenes::SceneField& field : scenes::sceneFields(scene)) {
    const std::string value = std::visit(Printer{}, field.slot);
    if (!value.empty()) lines.push_back(field.key + "=" + value);
  }
  return lines;
}

}  // namespace halsted::app
