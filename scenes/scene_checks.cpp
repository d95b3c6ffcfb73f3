#include "scenes/scene_checks.h"

#include "scenes/input_text.h"
#include "scenes/prolapse.h"
#include "scenes/tube_segment.h"

namespace halsted::scenes {
namespace {

constexpr int kMostParticles = 20000;          // [1] beyond it no machine keeps 1 kHz
constexpr double kThickestShare = 0.8;         // [1] of the radius: what the wall and the folds may take
constexpr double kLongestThread = 3.0;         // [m]

/// The place of the one of `keys` that was set last: what a user has set comes after the file, else the first of them; else the file.
std::string placeOf(const std::string& origin, const SettingOrigins& origins, std::initializer_list<const char*> keys) {
  for (const bool byUser : {true, false})
    for (const char* key : keys)
      if (const auto found = origins.find(key); found != origins.end() && (!byUser || found->second.rfind("--set ", 0) == 0)) return found->second;
  return quoted(origin) + ": " + *keys.begin();
}

/// Base, cuttable band and specimen one after the other; a lumen within both walls.
void checkProlapse(const AnatomyParams& anatomy, const std::string& origin, const SettingOrigins& origins) {
  if (2.0 * anatomy.wall + anatomy.gap > kThickestShare * anatomy.radius)
    throw InputError(placeOf(origin, origins, {"anatomy.gap", "anatomy.wall", "anatomy.radius"}) +
                     ": two walls and the gap between them leave no lumen in this radius");
  if (anatomy.cutHeight - anatomy.cutBand < 2.0 * kCutRow)
    throw InputError(placeOf(origin, origins, {"anatomy.cut_height", "anatomy.cut_band"}) + ": cut_band reaches down to the base");
  if (anatomy.length - foldHeight(anatomy) - anatomy.cutHeight - anatomy.cutBand < kLeastSpecimen)
    throw InputError(placeOf(origin, origins, {"anatomy.length", "anatomy.cut_height", "anatomy.cut_band"}) +
                     ": too short: nothing is left to cut off beyond cut_height and cut_band");
  if (2 * anatomy.around * (anatomy.along + 2 * static_cast<int>(2.0 * anatomy.cutBand / kCutRow) + 8) > kMostParticles)
    throw InputError(placeOf(origin, origins, {"anatomy.cut_band", "anatomy.around"}) + ": more than " + std::to_string(kMostParticles) + " particles");
}

void checkAnatomy(const AnatomyParams& anatomy, const std::string& origin, const SettingOrigins& origins) {
  if (anatomy.layout != "one_end" && anatomy.layout != "two_ends" && anatomy.layout != "end_to_end" && anatomy.layout != "prolapse")
    throw InputError(placeOf(origin, origins, {"anatomy.layout"}) + ": '" + quoted(anatomy.layout) +
                     "' is not one of one_end, two_ends, end_to_end, prolapse");
  if (anatomy.layout == "prolapse") checkProlapse(anatomy, origin, origins);
  const int ends = anatomy.layout == "one_end" || anatomy.layout == "prolapse" ? 1 : 2;
  if (2 * ends * anatomy.around * anatomy.along > kMostParticles)
    throw InputError(placeOf(origin, origins, {"anatomy.around", "anatomy.along"}) + ": 2 x around x along must be at most " +
                     std::to_string(kMostParticles) + " particles");
  if (anatomy.mesh.empty() && anatomy.wall + anatomy.haustraDepth > kThickestShare * anatomy.radius)
    throw InputError(placeOf(origin, origins, {"anatomy.wall", "anatomy.haustra_depth", "anatomy.radius"}) +
                     ": wall and haustra_depth together leave no lumen in this radius");
  if (anatomy.mesh.empty() && !anatomy.segment.empty())
    throw InputError(placeOf(origin, origins, {"anatomy.segment"}) + ": needs anatomy.mesh");
  try {
    parseSegment(anatomy.segment);
  } catch (const InputError& error) {
    throw InputError(placeOf(origin, origins, {"anatomy.segment"}) + ": " + error.what());
  }
}

bool hasClamp(const SimParams& params) {
  for (int hand = 0; hand < kHands; ++hand)
    if (params.tools[hand].kind == ToolKind::kAllis || params.second[hand].kind == ToolKind::kAllis) return true;
  return false;
}

void checkSuture(const SimParams& params, const std::string& origin, const SettingOrigins& origins) {
  if (params.thread.nodes * params.thread.segmentLength > kLongestThread)
    throw InputError(placeOf(origin, origins, {"thread.segment_length", "thread.nodes"}) + ": the thread is longer than " +
                     plainNumber(kLongestThread) + " m");
  if (params.thread.assist != ThreadAssist::kNone && !params.thread.knots)
    throw InputError(placeOf(origin, origins, {"thread.assist", "thread.knots"}) + ": needs thread.knots = true");
  if (params.thread.spare > 0 && !params.thread.knots)
    throw InputError(placeOf(origin, origins, {"thread.spare", "thread.knots"}) + ": needs thread.knots = true: only thread that meets itself is tied");
  for (int hand = 0; hand < kHands; ++hand)
    if (params.tools[hand].kind == ToolKind::kNone)
      throw InputError(placeOf(origin, origins, {hand == kLeft ? "tool.left.kind" : "tool.right.kind"}) + ": a hand holds an instrument; only a second may be none");
  if (params.assistant.clamps > 0 && !hasClamp(params))
    throw InputError(placeOf(origin, origins, {"assistant.clamps"}) + ": no hand has a clamp (kind = \"allis\") to hand over");
  if (params.anvil.radius > 0.0 && params.anvil.from == params.anvil.to)
    throw InputError(placeOf(origin, origins, {"anvil.to", "anvil.from"}) + ": the anvil has no length");
}

}  // namespace

void checkScene(const SceneFile& scene, const std::string& origin, const SettingOrigins& origins, AnatomyIs anatomy) {
  if (scene.title.empty()) throw InputError(quoted(origin) + ": title: is missing");
  if (!scene.trainPreset.empty() && !scene.presets.count(scene.trainPreset))
    throw InputError(placeOf(origin, origins, {"train_preset"}) + ": this scene has no preset '" + quoted(scene.trainPreset) + "'");
  const bool suture = scene.params.model == ModelKind::kSuture;
  if (suture && anatomy == AnatomyIs::kToBeBuilt) checkAnatomy(scene.params.anatomy, origin, origins);
  if (suture) checkSuture(scene.params, origin, origins);
  const Vec3 view = scene.camera.target - scene.camera.eye;  // [m]
  if (!(view.cross(scene.camera.up).norm() > 1e-6 * view.norm()))
    throw InputError(placeOf(origin, origins, {"camera.up", "camera.eye", "camera.target"}) +
                     ": eye and target coincide or up points along the view");
}

}  // namespace halsted::scenes
