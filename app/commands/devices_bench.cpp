#include "app/commands/devices_bench.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/commands/commands.h"
#include "app/errors.h"
#include "app/progress.h"
#include "app/run_summary.h"
#include "app/threads/haptic_thread.h"

namespace halsted::app {
namespace {

using haptics::bench::Bound;
using haptics::bench::Measurement;
using haptics::bench::Measurements;
using nlohmann::ordered_json;

constexpr double kStirred = 60.0;              // [s] issue of the energy: random motion of both hands
constexpr std::uint64_t kSeeds[] = {1, 2};
constexpr double kWatched = 5.0;               // [s] of real time for the jitter

ordered_json jsonOf(const char* section, const Measurement& m) {
  ordered_json row{{"section", section}, {"quantity", m.quantity}, {"condition", m.condition}, {"value", m.value}, {"unit", m.unit}};
  if (m.bound == Bound::kAtMost) row["at_most"] = m.limit;
  if (m.bound == Bound::kAtLeast) row["at_least"] = m.limit;
  row["met"] = m.met();
  return row;
}

void printRow(const Measurement& m) {
  char bound[48] = "";
  if (m.bound != Bound::kNone) std::snprintf(bound, sizeof bound, "%s %.4g", m.bound == Bound::kAtMost ? "<=" : ">=", m.limit);
  std::printf("  %-44s %-58s %11.4g %-6s %-10s %s\n", m.quantity.c_str(), m.condition.c_str(), m.value, m.unit.c_str(), bound,
              m.met() ? "" : "MISSED");
}

/// Prints as it goes, so that a minute of measuring shows something; JSON is one list at the end.
class Table {
 public:
  explicit Table(bool json) : json_(json) {}
  void add(const char* section, const Measurements& all) {
    if (!json_) std::printf("%s\n", section);
    for (const Measurement& m : all) {
      if (json_) rows_.push_back(jsonOf(section, m));
      else printRow(m);
      missed_ += !m.met();
    }
    std::fflush(stdout);
  }
  int finish() {
    if (json_) std::printf("%s\n", rows_.dump(2).c_str());
    else if (missed_ > 0) std::printf("%d bounds missed\n", missed_);
    else std::printf("every bound kept\n");
    return missed_ > 0 ? kCheckFailed : kDone;
  }

 private:
  bool json_;
  ordered_json rows_ = ordered_json::array();
  int missed_ = 0;
};

}  // namespace

Measurements measureSceneEnergy(const Scenario& scenario, double seconds, std::uint64_t seed, const std::function<void(double)>& progress) {
  const Hand hand = makeHand({}, scenario.start[kLeft]);           // for its loop's configuration
  return haptics::bench::measureTwoHands(scenario.model, scenario.start, hand.config, seconds, seed, progress);
}

Measurements measureJitter(const Scenario& scenario, double seconds) {
  Hands hands{makeHand({}, scenario.start[kLeft]), makeHand({}, scenario.start[kRight])};
  const auto links = std::make_unique<Links>(std::array<ToolSample, kHands>{}, RenderSnapshot{}, render::Frame{}, State{});
  HapticOutcome outcome;
  Durations bare;
  std::thread loop([&] { runHaptic(hands, {Mover::kNobody, Mover::kNobody}, *links, outcome); });
  std::thread beside([&] { runBareLoop(links->stop, bare); });
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  links->stop.store(true);
  loop.join();
  beside.join();
  const Percentiles late = outcome.lateness.percentiles(1e6), none = bare.percentiles(1e6);   // [us]
  const std::string condition = outcome.realtime ? "real-time priority" : "no real-time priority granted";
  return {{"rate", condition, static_cast<double>(outcome.ticks) / outcome.seconds, "Hz"},
          {"lateness p50", condition, late.p50, "us"}, {"lateness p99", condition, late.p99, "us"}, {"lateness max", condition, late.max, "us"},
          {"bare loop p50", condition, none.p50, "us"}, {"bare loop p99", condition, none.p99, "us"}, {"bare loop max", condition, none.max, "us"},
          {"skipped periods", condition, static_cast<double>(outcome.skippedPeriods), "1"}};
}

int benchDevices(bool json) {
  Table table(json);
  for (const haptics::bench::Section& section : haptics::bench::sections()) {
    Measurements all;
    {
      Progress progress;
      const auto heard = [&](double share) { progress.show(std::string(section.title) + number(" %.0f %%", 100.0 * share)); };   // [1]
      all = section.measure(heard);
    }
    table.add(section.title, all);
  }
  const Scenario scenario = scenarioFromScene("purse_string", {}, {});
  for (const std::uint64_t seed : kSeeds) {
    Measurements all;
    {
      Progress progress;
      all = measureSceneEnergy(scenario, kStirred, seed, [&](double time) { progress.show(time, "2 energy, two hands in purse_string"); });   // [s]
    }
    table.add("2 energy, two hands in purse_string", all);
  }
  table.add("8 jitter, real time", measureJitter(scenario, kWatched));
  return table.finish();
}

}  // namespace halsted::app
