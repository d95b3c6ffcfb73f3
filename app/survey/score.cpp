#include "app/survey/score.h"

#include <algorithm>
#include <cmath>

namespace halsted::app {
namespace {

std::vector<double> columnOf(const std::vector<std::vector<double>>& rows, std::size_t j) {   // [any]
  std::vector<double> column;                  // [any]
  for (const std::vector<double>& row : rows) column.push_back(row[j]);
  return column;
}

}  // namespace

Spread spreadOf(const std::vector<double>& values) {
  Spread s;
  const double n = static_cast<double>(values.size());       // [1]
  for (double v : values) s.mean += v / n;
  double sum = 0.0;                            // [any^2]
  for (double v : values) sum += (v - s.mean) * (v - s.mean);
  s.deviation = std::sqrt(sum / n);
  return s;
}

Quartiles quartilesOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {          // [points]
    const double place = share * static_cast<double>(values.size() - 1);   // [1]
    const std::size_t k = static_cast<std::size_t>(place), next = std::min(k + 1, values.size() - 1);
    return values[k] + (place - static_cast<double>(k)) * (values[next] - values[k]);
  };
  return {at(0.0), at(0.25), at(0.5), at(0.75), at(1.0)};
}

DelphiResult delphi(const std::vector<DelphiRound>& rounds, double limit) {
  DelphiResult result;
  for (std::size_t r = 0; r < rounds.size() && result.round == 0; ++r) {
    result.weight.clear();
    result.deviation.clear();
    for (std::size_t j = 0; j < rounds[r].weights.front().size(); ++j) {
      const Spread s = spreadOf(columnOf(rounds[r].weights, j));
      result.weight.push_back(s.mean);
      result.deviation.push_back(s.deviation);
    }
    // A deviation that is the limit itself, computed in another order, is not above it.
    if (*std::max_element(result.deviation.begin(), result.deviation.end()) <= limit + 1e-12) result.round = static_cast<int>(r) + 1;
  }
  double sum = 0.0;                            // [1]
  for (double w : result.weight) sum += w;
  for (double& w : result.weight) w /= sum;
  return result;
}

SystemResult scoreSystem(const SystemScores& scores, const std::vector<double>& subjective, double preference) {
  SystemResult result;
  result.system = scores.system;
  double sum = 0.0;                            // [points]
  for (std::size_t j = 0; j < subjective.size(); ++j) {
    const std::vector<double> column = columnOf(scores.scores, j);   // [points]
    result.index.push_back(spreadOf(column));
    result.quartiles.push_back(quartilesOf(column));
    sum += result.index.back().deviation;
  }
  for (std::size_t j = 0; j < subjective.size(); ++j) {
    result.objective.push_back(sum > 0.0 ? result.index[j].deviation / sum : subjective[j]);
    result.comprehensive.push_back(preference * subjective[j] + (1.0 - preference) * result.objective[j]);
  }
  for (const std::vector<double>& row : scores.scores) {
    double score = 0.0;                        // [points]
    for (std::size_t j = 0; j < subjective.size(); ++j) score += result.comprehensive[j] * row[j];
    result.score.push_back(score);
  }
  result.total = spreadOf(result.score);
  return result;
}

}  // namespace halsted::app
