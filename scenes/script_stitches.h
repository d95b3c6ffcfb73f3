#pragma once
/// Where a script sets its stitches: its keys stitch_at_deg and again_deg (scenes/expert.h). Private to the readers of scripts: toml++ is heavy.
#include <optional>
#include <string>
#include <vector>

#include "scenes/expert.h"
#include "scenes/toml_input.h"

namespace halsted::scenes {

inline constexpr std::size_t kMaxActions = 1000;   // of a script

/// Places of the stitches, one after the other: at one level of assistance, or at any.
struct StitchPlaces {
  std::optional<ThreadAssist> level;
  std::vector<double> degrees;                 // [deg]
  std::string where;                           // "file:line: key", for messages
};

struct StitchPlan {
  std::vector<StitchPlaces> places;
  std::vector<double> again;                   // [deg] from its place: where a stitch that is lost is set anew
};

/// "none" or "knot". All of these throw InputError for anything else than they ask for.
ThreadAssist levelOf(const std::string& text, const std::string& where);
std::vector<double> readAngles(const toml::node&, const std::string& where);   // [deg]
std::vector<StitchPlaces> readPlaces(const toml::node&, const std::string& origin, const std::string& key);

/// The script's actions, of which those of a stitch (all that follow the last "change_tools", or all there are) become as many as there are stitches and attempts at them.
/// Throws InputError where nothing is done at a place.
void setStitches(const StitchPlan&, std::vector<ExpertAction>& actions);

}  // namespace halsted::scenes
