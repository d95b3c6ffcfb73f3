#include "scenes/procedure_reader.h"

#include <cmath>
#include <span>

namespace halsted::scenes {
namespace {

constexpr double kLongestStep = 86400.0;  // [s] a day

double boundedSeconds(const toml::node& node, const std::string& where) {  // [s]
  const double seconds = requireNumber(node, where);  // [s]
  if (!(seconds >= 0.0 && seconds <= kLongestStep)) throw InputError(where + ": must be 0 to " + plainNumber(kLongestStep) + " s");
  return seconds;
}

Quantity readQuantity(const toml::node& node, const std::string& where) {
  const std::string text = requireText(node, where);
  Quantity quantity = Quantity::kTime;
  if (parseQuantity(text, quantity)) return quantity;
  std::string known;
  for (int i = 0; i < kQuantities; ++i) known += (i ? ", " : "") + std::string(name(static_cast<Quantity>(i)));
  throw InputError(where + ": '" + quoted(text) + "' is not one of " + known);
}

/// Reads `done` or `fault`; the latter also carries a name.
Condition readCondition(const toml::node& node, const std::string& origin, const std::string& key, std::string* faultName) {
  const toml::table* table = node.as_table();
  if (!table) throw InputError(whereIs(origin, node, key) + ": must be a table, is " + kindOf(node));
  Condition condition;
  for (const auto& [part, value] : *table) {
    const std::string where = whereIs(origin, value, key + "." + std::string(part.str()));
    if (part == "quantity") condition.quantity = readQuantity(value, where);
    else if (part == "min") condition.min = requireNumber(value, where);
    else if (part == "max") condition.max = requireNumber(value, where);
    else if (part == "hold_s") condition.hold = boundedSeconds(value, where);
    else if (part == "name" && faultName) *faultName = requireText(value, where);
    else throw InputError(where + ": unknown key");
  }
  const std::string where = whereIs(origin, node, key);
  if (!table->contains("quantity")) throw InputError(where + ": has no quantity");
  if (!table->contains("min") && !table->contains("max")) throw InputError(where + ": has neither min nor max");
  if (!(condition.min <= condition.max)) throw InputError(where + ": min must not exceed max");
  if (faultName && faultName->empty()) throw InputError(where + ": has no name");
  return condition;
}

ProcedureStep readStep(const toml::table& table, const std::string& origin) {
  ProcedureStep step;
  for (const auto& [part, value] : table) {
    const std::string key = "procedure." + std::string(part.str());
    const std::string where = whereIs(origin, value, key);
    if (part == "id") step.id = requireText(value, where);
    else if (part == "instruction") step.instruction = requireText(value, where);
    else if (part == "done") step.done = readCondition(value, origin, key, nullptr);
    else if (part == "fault") step.fault = readCondition(value, origin, key, &step.faultName);
    else if (part == "repeat_until") step.enough = readCondition(value, origin, key, nullptr);
    else if (part == "again_when") step.undone = readCondition(value, origin, key, nullptr);
    else if (part == "repeat_from" || part == "again_from") continue;    // names a step: looked up in the whole table
    else if (part == "limit_s") step.limit = boundedSeconds(value, where);
    else throw InputError(where + ": unknown key");
  }
  step.hasFault = table.contains("fault");
  const std::string where = whereIs(origin, table, "procedure");
  if (table.contains("repeat_from") != table.contains("repeat_until"))
    throw InputError(where + ": repeat_from and repeat_until go together");
  if (table.contains("again_from") != table.contains("again_when"))
    throw InputError(where + ": again_from and again_when go together");
  if (step.id.empty()) throw InputError(where + ": a step has no id");
  if (step.instruction.empty()) throw InputError(where + ": step '" + quoted(step.id) + "' has no instruction");
  if (!table.contains("done")) throw InputError(where + ": step '" + quoted(step.id) + "' has no done condition");
  return step;
}

/// The step of `upTo` that a key names; -1 where the key is not there.
int findStep(const toml::table& table, const std::string& origin, const char* key, std::span<const ProcedureStep> upTo) {
  const toml::node* node = table.get(key);
  if (!node) return -1;
  const std::string where = whereIs(origin, *node, std::string("procedure.") + key), id = requireText(*node, where);
  for (std::size_t i = 0; i < upTo.size(); ++i)
    if (upTo[i].id == id) return static_cast<int>(i);
  throw InputError(where + ": no step up to here is called '" + quoted(id) + "'");
}

}  // namespace

std::vector<ProcedureStep> readProcedure(const toml::node& node, const std::string& origin) {
  const toml::array* list = node.as_array();
  if (!list) throw InputError(whereIs(origin, node, "procedure") + ": must be [[procedure]] tables, is " + kindOf(node));
  std::vector<ProcedureStep> steps;
  for (const toml::node& entry : *list) {
    if (!entry.is_table()) throw InputError(whereIs(origin, entry, "procedure") + ": must be a table, is " + kindOf(entry));
    if (steps.size() == kMaxProcedureSteps)
      throw InputError(whereIs(origin, entry, "procedure") + ": more than " + std::to_string(kMaxProcedureSteps) + " steps");
    steps.push_back(readStep(*entry.as_table(), origin));
    for (std::size_t i = 0; i + 1 < steps.size(); ++i)
      if (steps[i].id == steps.back().id)
        throw InputError(whereIs(origin, entry, "procedure") + ": two steps are called '" + quoted(steps.back().id) + "'");
    const std::span<const ProcedureStep> all = steps;
    steps.back().repeatFrom = findStep(*entry.as_table(), origin, "repeat_from", all);
    steps.back().againFrom = findStep(*entry.as_table(), origin, "again_from", all.first(all.size() - 1));
  }
  return steps;
}

}  // namespace halsted::scenes
