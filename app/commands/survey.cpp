/// `halsted survey score`: raters' scores to weights and final scores.
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/errors.h"
#include "app/survey/score.h"
#include "scenes/input_text.h"

namespace halsted::app {
namespace {

using Json = nlohmann::ordered_json;

struct Subjective { std::vector<double> weight; int round = 0; };   // [1]

Subjective subjectiveWeights(const SurveyOptions& options, const Questionnaire& q) {
  Subjective s;
  for (const SurveyIndex& index : q.indices) s.weight.push_back(index.weight);
  if (options.delphi.empty()) return s;
  const std::vector<DelphiRound> rounds = readDelphi(options.delphi, q);
  const DelphiResult result = delphi(rounds, q.delphiLimit);
  if (result.round == 0) {
    std::size_t worst = 0;
    for (std::size_t j = 0; j < result.deviation.size(); ++j) if (result.deviation[j] > result.deviation[worst]) worst = j;
    throw scenes::InputError(scenes::quoted(options.delphi) + ": after " + std::to_string(rounds.size()) + " rounds the weights of " +
                             q.indices[worst].id + " still spread by " + scenes::plainNumber(result.deviation[worst]) + " (limit " +
                             scenes::plainNumber(q.delphiLimit) + "): ask the experts again");
  }
  return {result.weight, result.round};
}

Json asJson(const SystemResult& r, const Questionnaire& q) {
  Json indices = Json::array();
  for (std::size_t j = 0; j < q.indices.size(); ++j) {
    const Quartiles& b = r.quartiles[j];
    indices.push_back({{"id", q.indices[j].id}, {"mean", r.index[j].mean}, {"deviation", r.index[j].deviation},
                       {"box", {b.least, b.lower, b.median, b.upper, b.most}}, {"objective_weight", r.objective[j]},
                       {"comprehensive_weight", r.comprehensive[j]}});
  }
  const auto [least, most] = std::minmax_element(r.score.begin(), r.score.end());
  return {{"system", r.system}, {"mean", r.total.mean}, {"deviation", r.total.deviation}, {"least", *least}, {"most", *most},
          {"scores", r.score}, {"indices", indices}};
}

void printText(const std::vector<SystemResult>& results, const Questionnaire& q, const Subjective& subjective, double mu) {   // mu [1]
  std::printf("%s\n%zu raters, mu = %g%s\n\n%-24s %9s", q.title.c_str(), results.front().score.size(), mu,
              subjective.round > 0 ? (", experts agree in round " + std::to_string(subjective.round)).c_str() : "", "weights", "subject.");
  for (const SystemResult& r : results) std::printf(" %19s", r.system.substr(0, 19).c_str());
  std::printf("\n");
  for (std::size_t j = 0; j < q.indices.size(); ++j) {
    std::printf("%-24s %9.3f", q.indices[j].id.substr(0, 24).c_str(), subjective.weight[j]);
    for (const SystemResult& r : results) std::printf("   obj %.3f tot %.3f", r.objective[j], r.comprehensive[j]);
    std::printf("\n");
  }
  std::printf("\n%-24s %9s %9s %9s %9s\n", "final score", "mean", "spread", "least", "most");
  for (const SystemResult& r : results) {
    const auto [least, most] = std::minmax_element(r.score.begin(), r.score.end());
    std::printf("%-24s %9.3f %9.3f %9.3f %9.3f\n", r.system.c_str(), r.total.mean, r.total.deviation, *least, *most);
  }
}

}  // namespace

int scoreSurvey(const SurveyOptions& options) {
  const Questionnaire q = readQuestionnaire(options.questionnaire);
  const ScoreTable table = readScores(options.scores, q);
  const Subjective subjective = subjectiveWeights(options, q);
  const double mu = options.preference < 0.0 ? q.preference : options.preference;   // [1]
  std::vector<SystemResult> results;
  for (const SystemScores& system : table.systems) results.push_back(scoreSystem(system, subjective.weight, mu));
  if (!options.json) { printText(results, q, subjective, mu); return kDone; }
  Json systems = Json::array();
  for (const SystemResult& r : results) systems.push_back(asJson(r, q));
  std::printf("%s\n", Json{{"questionnaire", q.title}, {"raters", table.raters.size()}, {"mu", mu}, {"delphi_round", subjective.round},
                           {"subjective_weights", subjective.weight}, {"systems", systems}}.dump(2).c_str());
  return kDone;
}

}  // namespace halsted::app
