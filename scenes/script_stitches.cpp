#include "scenes/script_stitches.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scenes/scene.h"

namespace halsted::scenes {
namespace {

/// One stitch as a script writes it.
struct WrittenStitch {
  std::vector<ExpertAction> actions;
  std::optional<ThreadAssist> level;
  bool facing = true;                          // two ends that face each other are seen from opposite sides; the walls of a prolapse, one in the other, from the same
};

/// Which stitch of the script, and which attempt at it.
struct Turn { int stitch = 0, attempt = 0; };

/// What of one stitch is done at a level, and there only.
std::vector<ExpertAction> ofLevel(const std::vector<ExpertAction>& stitch, ThreadAssist level) {
  std::vector<ExpertAction> own;
  std::copy_if(stitch.begin(), stitch.end(), std::back_inserter(own), [&](const ExpertAction& a) { return a.assist.value_or(level) == level; });
  for (ExpertAction& a : own) a.assist = level;
  return own;
}

/// What is left of an attempt comes out before the next one, which has a thread of its own.
void clearAway(const WrittenStitch& written, Turn turn, std::vector<ExpertAction>& actions) {
  for (const std::string what : {"take_out", "fresh_thread"}) {
    if (written.actions.front().kind == what) continue;          // asks for it itself
    ExpertAction action;
    action.kind = what;
    action.line = written.actions.front().line;
    action.assist = written.level;
    action.stitch = turn.stitch;
    action.attempt = turn.attempt;
    actions.push_back(action);
  }
}

void setOne(const WrittenStitch& written, double place, Turn turn, std::vector<ExpertAction>& actions) {   // [deg]
  if (turn.attempt > 0) clearAway(written, turn, actions);
  for (ExpertAction action : written.actions) {
    if (action.kind == "bite") action.angleDegrees += action.bowel == 1 && written.facing ? -place : place;
    action.stitch = turn.stitch;
    action.attempt = turn.attempt;
    actions.push_back(action);
  }
}

}  // namespace

ThreadAssist levelOf(const std::string& text, const std::string& where) {
  if (text != "none" && text != "knot") throw InputError(where + ": must be \"none\" or \"knot\"");
  return text == "knot" ? ThreadAssist::kKnot : ThreadAssist::kNone;
}

std::vector<double> readAngles(const toml::node& node, const std::string& where) {   // [deg]
  constexpr std::size_t kMost = 60;
  const toml::array* list = node.as_array();
  if (!list || list->empty() || list->size() > kMost) throw InputError(where + ": must be a list of 1 to 60 angles");
  std::vector<double> places;                  // [deg]
  for (const toml::node& entry : *list) {
    places.push_back(requireNumber(entry, where));
    if (!(std::abs(places.back()) <= 180.0)) throw InputError(where + ": must be -180 to 180");
  }
  return places;
}

std::vector<StitchPlaces> readPlaces(const toml::node& node, const std::string& origin, const std::string& key) {
  const toml::table* levels = node.as_table();
  if (!levels) return {{std::nullopt, readAngles(node, whereIs(origin, node, key)), whereIs(origin, node, key)}};
  std::vector<StitchPlaces> places;
  for (const auto& [part, angles] : *levels) {
    const std::string name(part.str()), where = whereIs(origin, angles, key + "." + name);
    places.push_back({levelOf(name, where), readAngles(angles, where), where});
  }
  if (places.size() != 2) throw InputError(whereIs(origin, node, key) + ": must have angles for both levels, none and knot");
  return places;
}

void setStitches(const StitchPlan& plan, std::vector<ExpertAction>& actions) {
  const auto changed = std::find_if(actions.rbegin(), actions.rend(), [](const ExpertAction& a) { return a.kind == "change_tools"; });
  const std::vector<ExpertAction> once(changed.base(), actions.end());
  actions.erase(changed.base(), actions.end());
  const bool facing = std::none_of(actions.begin(), actions.end(), [](const ExpertAction& a) { return a.kind == "cut_ring"; });
  int stitch = 0;
  for (const StitchPlaces& places : plan.places) {
    WrittenStitch written{places.level ? ofLevel(once, *places.level) : once, places.level, facing};
    if (written.actions.empty()) throw InputError(places.where + ": no action is done there: none follows the last change_tools at this level of assistance");
    for (std::size_t p = 0; p < places.degrees.size(); ++p) {
      const double place = places.degrees[p];  // [deg]
      // A fresh thread at a stitch's end is asked for between stitches and not after the last.
      if (p + 1 == places.degrees.size() && written.actions.size() > 1 && written.actions.back().kind == "fresh_thread") written.actions.pop_back();
      setOne(written, place, {stitch, 0}, actions);
      for (std::size_t i = 0; i < plan.again.size(); ++i) setOne(written, place + plan.again[i], {stitch, static_cast<int>(i) + 1}, actions);
      if (actions.size() > kMaxActions) throw InputError(places.where + ": more than 1000 actions");
      ++stitch;
    }
  }
}

}  // namespace halsted::scenes
