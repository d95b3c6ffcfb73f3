#include "app/survey/score_table.h"

#include <algorithm>
#include <cmath>

#include "app/survey/csv.h"
#include "scenes/input_text.h"

namespace halsted::app {
namespace {

using scenes::plainNumber;

/// The columns of the indices, and no others but the two named.
std::vector<int> indexColumns(const CsvTable& table, const Questionnaire& q, const std::string& first, const std::string& second) {
  std::vector<int> columns;
  for (const SurveyIndex& index : q.indices) columns.push_back(table.column(index.id));
  for (const std::string& name : table.header) {
    const bool known = name == first || name == second ||
                       std::any_of(q.indices.begin(), q.indices.end(), [&](const SurveyIndex& index) { return index.id == name; });
    if (!known) table.fail(1, "column " + name + " is none of the questionnaire's");
  }
  return columns;
}

/// The place of a name in a list, appended when it is new.
std::size_t placeOf(const std::string& name, std::vector<std::string>& names) {
  const std::size_t place = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  if (place == names.size()) names.push_back(name);
  return place;
}

std::vector<double> scoresOf(const CsvTable& table, const CsvRow& row, const std::vector<int>& columns, const Questionnaire& q) {   // [points]
  std::vector<double> scores;                  // [points]
  for (int column : columns) {
    const double score = table.number(row, column);          // [points]
    if (score < q.lowest || score > q.highest)
      table.fail(row.line, table.header[column] + ": " + plainNumber(score) + " is outside the scale " + plainNumber(q.lowest) + " to " +
                               plainNumber(q.highest));
    scores.push_back(score);
  }
  return scores;
}

void requireEveryRater(const ScoreTable& scores, const std::string& file) {
  if (scores.raters.size() < 2) throw scenes::InputError(scenes::quoted(file) + ": only one rater; a spread needs at least two");
  for (const SystemScores& system : scores.systems)
    for (std::size_t r = 0; r < scores.raters.size(); ++r)
      if (system.scores.size() <= r || system.scores[r].empty())
        throw scenes::InputError(scenes::quoted(file) + ": rater " + scenes::quoted(scores.raters[r]) + " did not score system " +
                                 scenes::quoted(system.system));
}

}  // namespace

ScoreTable readScores(const std::string& file, const Questionnaire& q) {
  const CsvTable table = readCsv(file);
  const int system = table.column("system"), rater = table.column("rater");
  const std::vector<int> columns = indexColumns(table, q, "system", "rater");
  ScoreTable scores;
  std::vector<std::string> names;
  for (const CsvRow& row : table.rows) {
    if (row.fields[system].empty()) table.fail(row.line, "system: is missing");
    if (row.fields[rater].empty()) table.fail(row.line, "rater: is missing");
    const std::size_t s = placeOf(row.fields[system], names), r = placeOf(row.fields[rater], scores.raters);
    if (s == scores.systems.size()) scores.systems.push_back({row.fields[system], {}});
    std::vector<std::vector<double>>& rows = scores.systems[s].scores;   // [points]
    if (rows.size() <= r) rows.resize(r + 1);
    if (!rows[r].empty()) table.fail(row.line, "rater " + row.fields[rater] + " scores system " + row.fields[system] + " a second time");
    rows[r] = scoresOf(table, row, columns, q);
  }
  requireEveryRater(scores, file);
  return scores;
}

std::vector<DelphiRound> readDelphi(const std::string& file, const Questionnaire& q) {
  const CsvTable table = readCsv(file);
  const int round = table.column("round"), expert = table.column("expert");
  const std::vector<int> columns = indexColumns(table, q, "round", "expert");
  std::vector<DelphiRound> rounds;
  std::vector<std::vector<std::string>> experts;
  for (const CsvRow& row : table.rows) {
    const double number = table.number(row, round);          // [1]
    const double most = static_cast<double>(rounds.size()) + 1.0;   // [1]
    if (number != std::floor(number) || number < 1.0 || number > most) table.fail(row.line, "round: rounds count from 1, one after the other");
    if (number == most) { rounds.emplace_back(); experts.emplace_back(); }
    const std::size_t k = static_cast<std::size_t>(number) - 1;
    if (std::find(experts[k].begin(), experts[k].end(), row.fields[expert]) != experts[k].end())
      table.fail(row.line, "expert " + row.fields[expert] + " is there twice in round " + row.fields[round]);
    experts[k].push_back(row.fields[expert]);
    std::vector<double> weights;               // [1]
    double sum = 0.0;                          // [1]
    for (int column : columns) {
      const double weight = table.number(row, column);       // [1]
      if (weight < 0.0 || weight > 1.0) table.fail(row.line, table.header[column] + ": a weight is between 0 and 1");
      weights.push_back(weight);
      sum += weight;
    }
    if (std::abs(sum - 1.0) > 0.005) table.fail(row.line, "the weights add up to " + plainNumber(sum) + ", not 1");
    rounds[k].weights.push_back(std::move(weights));
  }
  return rounds;
}

}  // namespace halsted::app
