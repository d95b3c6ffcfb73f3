#include "app/survey/questionnaire.h"

#include <cmath>
#include <filesystem>

#include "scenes/scene.h"
#include "scenes/toml_input.h"

namespace halsted::app {
namespace {

using scenes::InputError;

constexpr std::size_t kMostBytes = 1 << 20, kMostIndices = 200;

std::string fileOf(const std::string& nameOrPath) {
  const std::filesystem::path path(nameOrPath);
  if (path.extension() == ".toml" || path.has_parent_path()) return nameOrPath;
  return scenes::scenesDirectory() + "/surveys/" + nameOrPath + ".toml";
}

double numberIn(const toml::node& node, const std::string& where, double low, double high) {   // [1]
  const double value = scenes::requireNumber(node, where);   // [1]
  if (!(value >= low && value <= high))
    throw InputError(where + ": must be between " + scenes::plainNumber(low) + " and " + scenes::plainNumber(high));
  return value;
}

void readScale(const toml::node& node, const std::string& where, Questionnaire& q) {
  const toml::array* range = node.as_array();
  if (!range || range->size() != 2) throw InputError(where + ": must be two numbers, lowest and highest");
  q.lowest = numberIn(*range->get(0), where, -1e6, 1e6);
  q.highest = numberIn(*range->get(1), where, -1e6, 1e6);
  if (!(q.highest > q.lowest)) throw InputError(where + ": the highest must be above the lowest");
}

SurveyIndex readIndex(const toml::table& table, const std::string& origin, bool& weighted) {
  SurveyIndex index;
  for (const auto& [key, node] : table) {
    const std::string name(key.str()), where = scenes::whereIs(origin, node, name);
    if (name == "id") index.id = scenes::requireText(node, where);
    else if (name == "text") index.text = scenes::requireText(node, where);
    else if (name == "weight") { index.weight = numberIn(node, where, 0.0, 1.0); weighted = true; }
    else throw InputError(where + ": unknown key");
  }
  if (index.id.empty()) throw InputError(scenes::whereIs(origin, table, "index") + ": has no id");
  return index;
}

void readIndices(const toml::node& node, const std::string& origin, Questionnaire& q) {
  const toml::array* list = node.as_array();
  if (!list || list->empty() || list->size() > kMostIndices)
    throw InputError(scenes::whereIs(origin, node, "index") + ": must be 1 to 200 tables [[index]]");
  std::size_t weights = 0;
  double sum = 0.0;                            // [1]
  for (const toml::node& item : *list) {
    if (!item.is_table()) throw InputError(scenes::whereIs(origin, item, "index") + ": must be a table");
    bool weighted = false;
    const SurveyIndex index = readIndex(*item.as_table(), origin, weighted);
    for (const SurveyIndex& other : q.indices)
      if (other.id == index.id) throw InputError(scenes::whereIs(origin, item, index.id) + ": appears twice");
    weights += weighted;
    sum += index.weight;
    q.indices.push_back(index);
  }
  if (weights == 0) for (SurveyIndex& index : q.indices) index.weight = 1.0 / static_cast<double>(q.indices.size());
  else if (weights != q.indices.size()) throw InputError(scenes::whereIs(origin, node, "weight") + ": all indices need one, or none");
  else if (std::abs(sum - 1.0) > 0.005) throw InputError(scenes::whereIs(origin, node, "weight") + ": weights add up to " + scenes::plainNumber(sum) + ", not 1");
  else for (SurveyIndex& index : q.indices) index.weight /= sum;   // printed weights are rounded
}

}  // namespace

Questionnaire readQuestionnaire(const std::string& nameOrPath) {
  const std::string file = fileOf(nameOrPath);
  const toml::table table = scenes::parseToml(scenes::readTextFile(file, kMostBytes), file);
  Questionnaire q;
  for (const auto& [key, node] : table) {
    const std::string name(key.str()), where = scenes::whereIs(file, node, name);
    if (name == "title") q.title = scenes::requireText(node, where);
    else if (name == "scale") readScale(node, where, q);
    else if (name == "mu") q.preference = numberIn(node, where, 0.0, 1.0);
    else if (name == "delphi_limit") q.delphiLimit = numberIn(node, where, 0.0, 1.0);
    else if (name == "index") readIndices(node, file, q);
    else throw InputError(where + ": unknown key");
  }
  if (q.indices.empty()) throw InputError(scenes::quoted(file) + ": no [[index]]");
  return q;
}

}  // namespace halsted::app
