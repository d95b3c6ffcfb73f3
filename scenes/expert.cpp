#include "scenes/expert.h"

#include <algorithm>
#include <span>

#include "scenes/knot_plan.h"
#include "scenes/scene.h"
#include "scenes/script_stitches.h"
#include "scenes/toml_input.h"

namespace halsted::scenes {
namespace {

constexpr std::size_t kMaxScriptBytes = 1 << 20;

struct NumberKey {
  const char* key;
  double ExpertAction::* field;
  double min, max, unit;                       // as written in the file; `unit` turns it into SI [1]
};

constexpr NumberKey kSutureNumbers[] = {
    {"angle_deg", &ExpertAction::angleDegrees, -360.0, 360.0, 1.0}, {"depth_mm", &ExpertAction::depth, 1.0, 15.0, 1e-3},
    {"exit_depth_mm", &ExpertAction::exitDepth, 1.0, 15.0, 1e-3},   {"sink_mm", &ExpertAction::sink, -1.0, 4.0, 1e-3},
    {"tilt_deg", &ExpertAction::tilt, -45.0, 45.0, 1.0},
    {"width_mm", &ExpertAction::width, 2.0, 14.0, 1e-3},            {"pull_mm", &ExpertAction::pull, 0.0, 300.0, 1e-3},
    {"tension_n", &ExpertAction::tension, 0.05, 20.0, 1.0},         {"limit_s", &ExpertAction::seconds, 0.01, 600.0, 1.0},
    {"tail_mm", &ExpertAction::tail, 10.0, 120.0, 1e-3},
    {"draw_deg", &ExpertAction::drawDegrees, 0.0, 80.0, 1.0},
    {"gap_mm", &ExpertAction::gap, 0.1, 10.0, 1e-3},
    {"beyond_hand_mm", &ExpertAction::beyondHand, 5.0, 40.0, 1e-3},
    {"long_end_mm", &ExpertAction::longEnd, 30.0, 120.0, 1e-3},
    {"from_deg", &ExpertAction::angleDegrees, -360.0, 360.0, 1.0},  {"height_mm", &ExpertAction::height, 1.0, 100.0, 1e-3},
    {"speed_mm_s", &ExpertAction::speed, 0.1, 50.0, 1e-3},
};
constexpr NumberKey kNeedleNumbers[] = {
    {"angle_deg", &ExpertAction::angleDegrees, 5.0, 90.0, 1.0},     {"depth_mm", &ExpertAction::depth, 0.5, 100.0, 1e-3},
    {"twirl_deg", &ExpertAction::twirlDegrees, 10.0, 720.0, 1.0},   {"lift_mm", &ExpertAction::lift, 0.5, 50.0, 1e-3},
    {"period_s", &ExpertAction::period, 0.2, 20.0, 1.0},            {"speed_mm_s", &ExpertAction::speed, 0.1, 200.0, 1e-3},
    {"distance_mm", &ExpertAction::distance, 1.0, 60.0, 1e-3},      {"limit_s", &ExpertAction::seconds, 0.01, 600.0, 1.0},
};
constexpr const char* kSutureKinds[] = {"bite", "draw", "take_tails", "tighten", "tie", "cut", "take_stay", "traction", "let_go", "take_out", "fresh_thread", "change_tools", "hold",
                                        "hold_fold", "hand_over", "cut_ring", "take_away"};
constexpr const char* kNeedleKinds[] = {"find", "press", "insert", "twirl", "lift_thrust", "withdraw"};

bool isOneOf(std::span<const char* const> kinds, const std::string& text) {
  return std::any_of(kinds.begin(), kinds.end(), [&](const char* kind) { return text == kind; });
}

bool isTaking(const std::string& kind) { return kind == "take_tails" || kind == "take_stay"; }

void readNumber(const toml::node& node, const std::string& where, const std::string& key, ExpertAction& action) {
  const bool needle = isOneOf(kNeedleKinds, action.kind);
  for (const NumberKey& n : needle ? std::span<const NumberKey>(kNeedleNumbers) : std::span<const NumberKey>(kSutureNumbers)) {
    if (key != n.key) continue;
    const double value = requireNumber(node, where);
    if (!(value >= n.min && value <= n.max)) throw InputError(where + ": must be " + plainNumber(n.min) + " to " + plainNumber(n.max));
    action.*n.field = value * n.unit;
    return;
  }
  throw InputError(where + ": unknown key");
}

int readBowel(const toml::node& node, const std::string& where) {
  const double number = requireNumber(node, where);              // [1]
  if (number != 1.0 && number != 2.0) throw InputError(where + ": must be 1 or 2");
  return number == 1.0 ? 0 : 1;
}

int readWall(const toml::node& node, const std::string& where) {
  const std::string text = requireText(node, where);
  if (text != "outer" && text != "inner") throw InputError(where + ": must be \"outer\" or \"inner\"");
  return text == "outer" ? 0 : 1;
}

bool readTruth(const toml::node& node, const std::string& where) {
  if (!node.is_boolean()) throw InputError(where + ": must be true or false");
  return *node.value<bool>();
}

std::string readKind(const toml::table& table, const std::string& origin) {
  const toml::node* node = table.get("do");
  if (!node) throw InputError(whereIs(origin, table, "action") + ": has no do");
  const std::string where = whereIs(origin, *node, "action.do"), kind = requireText(*node, where);
  if (isOneOf(kSutureKinds, kind) || isOneOf(kNeedleKinds, kind)) return kind;
  std::string known;
  for (const std::span<const char* const> kinds : {std::span<const char* const>(kSutureKinds), std::span<const char* const>(kNeedleKinds)})
    for (const char* name : kinds) known += (known.empty() ? "" : ", ") + std::string(name);
  throw InputError(where + ": '" + quoted(kind) + "' is not one of " + known);
}

int readCycles(const toml::node& node, const std::string& where) {
  constexpr std::int64_t kMost = 1000;
  if (!node.is_integer()) throw InputError(where + ": must be an integer, is " + kindOf(node));
  const std::int64_t value = *node.value<std::int64_t>();
  if (value < 1 || value > kMost) throw InputError(where + ": must be 1 to 1000");
  return static_cast<int>(value);
}

std::string readTie(const toml::node& node, const std::string& where) {
  const std::string text = requireText(node, where);
  if (parseThrows(text).empty())
    throw InputError(where + ": '" + quoted(text) + "' is not a knot: turns 1 to 3 joined by = or x, such as 1=1 or 2=1=1");
  return text;
}

ExpertAction readAction(const toml::table& table, const std::string& origin) {
  ExpertAction action;
  action.line = static_cast<int>(table.source().begin.line);
  action.kind = readKind(table, origin);
  const bool needle = isOneOf(kNeedleKinds, action.kind);
  if (needle) action.depth = 0.0;              // the textbook's
  for (const auto& [part, node] : table) {
    const std::string key(part.str()), where = whereIs(origin, node, "action." + key);
    if (key == "do") continue;
    if (needle && key == "point") action.point = requireText(node, where);
    else if (needle && key == "cycles") action.cycles = readCycles(node, where);
    else if (!needle && key == "bowel") action.bowel = readBowel(node, where);
    else if (!needle && key == "wall") action.bowel = readWall(node, where);
    else if (!needle && key == "counter_clockwise") action.counterClockwise = readTruth(node, where);
    else if (!needle && key == "across") action.across = readTruth(node, where);
    else if (!needle && key == "through") action.through = readTruth(node, where);
    else if (isTaking(action.kind) && key == "unless_held") action.unlessHeld = readTruth(node, where);
    else if (!needle && key == "assist") action.assist = levelOf(requireText(node, where), where);
    else if (!needle && key == "tie") action.tie = readTie(node, where);
    else readNumber(node, where, key, action);
  }
  if (action.kind == "tie" && action.tie.empty()) throw InputError(whereIs(origin, table, "action") + ": do = \"tie\" has no tie = \"1=1\"");
  return action;
}

}  // namespace

bool isSutureAction(const std::string& kind) { return isOneOf(kSutureKinds, kind); }

ExpertScript readExpert(const std::string& path) { return parseExpert(readTextFile(path, kMaxScriptBytes), path); }

ExpertScript parseExpert(const std::string& text, const std::string& origin) {
  ExpertScript script;
  script.origin = origin;
  script.text = text;
  const toml::table file = parseToml(text, origin);
  StitchPlan stitches;
  for (const auto& [part, node] : file) {
    const std::string key(part.str());
    if (key == "scene") {
      script.scene = requireText(node, whereIs(origin, node, key));
      script.sceneLine = static_cast<int>(node.source().begin.line);
      continue;
    }
    if (key == "stitch_at_deg") { stitches.places = readPlaces(node, origin, key); continue; }
    if (key == "again_deg") { stitches.again = readAngles(node, whereIs(origin, node, key)); continue; }
    if (key != "action") throw InputError(whereIs(origin, node, key) + ": unknown key");
    const toml::array* list = node.as_array();
    if (!list) throw InputError(whereIs(origin, node, key) + ": must be [[action]] tables, is " + kindOf(node));
    for (const toml::node& entry : *list) {
      if (!entry.is_table()) throw InputError(whereIs(origin, entry, key) + ": must be a table, is " + kindOf(entry));
      if (script.actions.size() == kMaxActions) throw InputError(whereIs(origin, entry, key) + ": more than 1000 actions");
      script.actions.push_back(readAction(*entry.as_table(), origin));
    }
  }
  if (script.scene.empty()) throw InputError(origin + ":1: scene: is missing");
  if (script.actions.empty()) throw InputError(origin + ":1: action: the script does nothing");
  if (stitches.places.empty() && !stitches.again.empty()) throw InputError(origin + ":1: again_deg: needs stitch_at_deg");
  if (!stitches.places.empty()) setStitches(stitches, script.actions);
  return script;
}

}  // namespace halsted::scenes
