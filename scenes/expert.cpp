#include "scenes/expert.h"

#include <cmath>

#include "scenes/knot_plan.h"
#include "scenes/scene.h"
#include "scenes/toml_input.h"

namespace halsted::scenes {
namespace {

constexpr std::size_t kMaxScriptBytes = 1 << 20, kMaxActions = 1000;

struct NumberKey {
  const char* key;
  double ExpertAction::* field;
  double min, max, unit;                       // as written in the file; `unit` turns it into SI [1]
};

constexpr NumberKey kNumbers[] = {
    {"angle_deg", &ExpertAction::angleDegrees, -360.0, 360.0, 1.0}, {"depth_mm", &ExpertAction::depth, 1.0, 15.0, 1e-3},
    {"exit_depth_mm", &ExpertAction::exitDepth, 1.0, 15.0, 1e-3},   {"sink_mm", &ExpertAction::sink, -1.0, 4.0, 1e-3},
    {"tilt_deg", &ExpertAction::tilt, -45.0, 45.0, 1.0},
    {"width_mm", &ExpertAction::width, 2.0, 14.0, 1e-3},            {"pull_mm", &ExpertAction::pull, 0.0, 300.0, 1e-3},
    {"tension_n", &ExpertAction::tension, 0.05, 20.0, 1.0},         {"limit_s", &ExpertAction::seconds, 0.01, 600.0, 1.0},
    {"long_end_mm", &ExpertAction::longEnd, 30.0, 120.0, 1e-3},
};

bool isKind(const std::string& text) {
  if (text == "cut" || text == "take_stay" || text == "traction") return true;
  return text == "bite" || text == "take_tails" || text == "tighten" || text == "tie" || text == "let_go" || text == "hold";
}

void readNumber(const toml::node& node, const std::string& where, const std::string& key, ExpertAction& action) {
  for (const NumberKey& n : kNumbers) {
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

ExpertAction readAction(const toml::table& table, const std::string& origin) {
  ExpertAction action;
  action.line = static_cast<int>(table.source().begin.line);
  for (const auto& [part, node] : table) {
    const std::string key(part.str()), where = whereIs(origin, node, "action." + key);
    if (key == "bowel") { action.bowel = readBowel(node, where); continue; }
    if (key == "counter_clockwise") {
      if (!node.is_boolean()) throw InputError(where + ": must be true or false");
      action.counterClockwise = *node.value<bool>();
      continue;
    }
    if (key == "tie") {
      action.tie = requireText(node, where);
      if (parseThrows(action.tie).empty())
        throw InputError(where + ": '" + quoted(action.tie) + "' is not a knot: turns 1 to 3 joined by = or x, such as 1=1 or 2=1=1");
      continue;
    }
    if (key != "do") { readNumber(node, where, key, action); continue; }
    action.kind = requireText(node, where);
    if (!isKind(action.kind)) throw InputError(where + ": '" + quoted(action.kind) + "' is not one of bite, take_tails, tighten, tie, cut, take_stay, traction, let_go, hold");
  }
  if (action.kind == "tie" && action.tie.empty()) throw InputError(whereIs(origin, table, "action") + ": do = \"tie\" has no tie = \"1=1\"");
  if (action.kind.empty()) throw InputError(whereIs(origin, table, "action") + ": has no do");
  return action;
}

}  // namespace

ExpertScript readExpert(const std::string& path) { return parseExpert(readTextFile(path, kMaxScriptBytes), path); }

ExpertScript parseExpert(const std::string& text, const std::string& origin) {
  ExpertScript script;
  script.text = text;
  const toml::table file = parseToml(text, origin);
  for (const auto& [part, node] : file) {
    const std::string key(part.str());
    if (key == "scene") { script.scene = requireText(node, whereIs(origin, node, key)); continue; }
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
  return script;
}

}  // namespace halsted::scenes
