#pragma once
/// Tables of scores and of weights as raters hand them in: CSV with a header, comma-separated, a row per rater.
#include <string>
#include <vector>

#include "app/survey/questionnaire.h"

namespace halsted::app {

struct SystemScores {
  std::string system;
  std::vector<std::vector<double>> scores;     // [points] per rater, per index
};

struct ScoreTable {
  std::vector<std::string> raters;             // in the order of their first row
  std::vector<SystemScores> systems;           // every one scored by every rater, in that order
};

/// Columns `system`, `rater` and one per index, by id. Throws scenes::InputError "file:line: ..." for a column that is missing or
/// unknown, a score that is missing, not a number or outside the scale, a rater who is there twice or not at all, fewer than two raters.
ScoreTable readScores(const std::string& file, const Questionnaire&);

struct DelphiRound { std::vector<std::vector<double>> weights; };   // [1] per expert, per index

/// Columns `round`, `expert` and one per index. Rounds count from 1 without gaps; an expert's weights add up to 1.
std::vector<DelphiRound> readDelphi(const std::string& file, const Questionnaire&);

}  // namespace halsted::app
