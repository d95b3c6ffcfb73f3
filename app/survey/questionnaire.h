#pragma once
/// What raters are asked: a TOML file (scenes/surveys/NAME.toml). The seven indices of acupuncture-force-net 2021 and the five exit
/// questions of suturing-xpbd are two of them.
///   title = "..."   scale = [0, 10]   mu = 0.4   delphi_limit = 0.1
///   [[index]]  id = "force_feedback"  text = "Force feedback"  weight = 0.24      (weights: all or none; none: every index the same)
#include <string>
#include <vector>

namespace halsted::app {

struct SurveyIndex {
  std::string id, text;
  double weight = 0.0;                         // [1] subjective, sum over the indices 1
};

struct Questionnaire {
  std::string title;
  double lowest = 0.0, highest = 10.0;         // [points] of the scale
  double preference = 0.4;                     // [1] mu: share of the subjective weight, eq. 13
  double delphiLimit = 0.1;                    // [1] standard deviation at which the experts agree
  std::vector<SurveyIndex> indices;
};

/// A name (scenes/surveys/NAME.toml) or the path of a TOML file. Throws scenes::InputError "file:line: key: what is wrong".
Questionnaire readQuestionnaire(const std::string& nameOrPath);

}  // namespace halsted::app
