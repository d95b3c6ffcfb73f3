#include "app/run_summary.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "sim/whole_seam.h"

namespace halsted::app {

using Json = nlohmann::ordered_json;

std::string number(const char* format, double value) {   // any unit
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

RunSummary summariseRun(const std::string& scene, const std::string& title, const Model& model, const State& state,
                        const Durations& steps, double wall) {   // wall [s]
  RunSummary run;
  run.scene = scene;
  run.title = title;
  run.assist = model.params.thread.assist == ThreadAssist::kKnot ? "knot" : "none";
  run.dt = model.params.dt;
  run.steps = state.step;
  const ProcedureState& progress = state.procedure;
  const int size = static_cast<int>(model.procedure.size());
  run.completed = size > 0 && progress.current >= size;
  for (int i = 0; i < size; ++i) {
    const bool done = i < progress.current;
    run.procedure.push_back({model.procedure[i].id, model.procedure[i].instruction, done, done ? progress.finished[i] : 0.0,
                             progress.faults[i]});
  }
  const double simulated = static_cast<double>(state.step) * run.dt;   // [s]
  run.metrics = summarise(state.metrics, simulated);
  for (const auto& row : summariseStitches(model, state)) run.metrics.push_back(row);
  run.stateHash = hash(state);
  run.stepMilliseconds = steps.percentiles(1e3);
  run.realtimeFactor = wall > 0.0 ? static_cast<double>(steps.count()) * run.dt / wall : 0.0;
  return run;
}

std::string textOf(const RunSummary& run) {
  std::string text = run.title + " (" + run.scene + "): " + (run.completed ? "completed" : "not completed") + " in " +
                     number("%.2f s", static_cast<double>(run.steps) * run.dt) + " simulated\n";
  if (run.assist != "none") text += "  with assistance: " + run.assist + " (knots are placed and held, not tied by friction)\n";
  for (std::size_t row = 0; row < run.procedure.size(); ++row) {
    const ProcedureLine& line = run.procedure[row];
    text += line.done ? "  done  " : "  open  ";
    text += line.id + (line.done ? number("  at %.2f s", line.time) : "");
    if (line.faults > 0) text += "  faults: " + std::to_string(line.faults);
    text += "\n";
    for (const FaultLine& fault : run.faults)
      if (fault.row == static_cast<int>(row)) text += number("          fault at %.2f s: ", fault.time) + fault.name + "\n";
  }
  for (const auto& [name, value] : run.metrics) text += "  " + name + " " + number("%.6g", value) + "\n";
  text += "  state " + hexadecimal(run.stateHash) + " after " + std::to_string(run.steps) + " steps of " + number("%g ms", run.dt * 1e3) + "\n";
  text += "  physics step p50 " + number("%.3f ms", run.stepMilliseconds.p50) + ", p99 " + number("%.3f ms", run.stepMilliseconds.p99) +
          ", max " + number("%.3f ms", run.stepMilliseconds.max) + ", " + number("%.2f", run.realtimeFactor) + " times real time";
  if (run.realtimeFactorCpu > 0.0) text += number(", %.2f with a core of its own", run.realtimeFactorCpu);
  text += "\n";
  return text;
}

std::string jsonOf(const RunSummary& run, const std::string& extra) {
  Json json;
  json["scene"] = run.scene;
  json["assist"] = run.assist;
  json["dt_s"] = run.dt;
  json["steps"] = run.steps;
  json["completed"] = run.completed;
  json["procedure"] = Json::array();
  for (const ProcedureLine& line : run.procedure)
    json["procedure"].push_back({{"id", line.id}, {"done", line.done}, {"time_s", line.time}, {"faults", line.faults}});
  json["faults"] = Json::array();
  for (const FaultLine& fault : run.faults) json["faults"].push_back({{"step", run.procedure[fault.row].id}, {"name", fault.name}, {"time_s", fault.time}});
  json["metrics"] = Json::object();
  for (const auto& [name, value] : run.metrics) json["metrics"][name] = value;
  json["state_hash"] = hexadecimal(run.stateHash);
  const Percentiles& step = run.stepMilliseconds;
  json["timing"] = {{"physics_step_ms", {{"p50", step.p50}, {"p99", step.p99}, {"max", step.max}}}, {"realtime_factor", run.realtimeFactor}};
  if (run.realtimeFactorCpu > 0.0) json["timing"]["realtime_factor_cpu"] = run.realtimeFactorCpu;
  if (!extra.empty()) json.update(Json::parse("{" + extra + "}"));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace halsted::app
