#pragma once
/// The comprehensive weighted scoring of acupuncture-force-net 2021, section 4.2: experts weigh the indices (Delphi), the scores weigh
/// them too (mean square deviation), and both together make one number per rater.
#include <vector>

#include "app/survey/score_table.h"

namespace halsted::app {

/// Mean and standard deviation with 1 / n, as eqs. 10 and 11.
struct Spread { double mean = 0.0, deviation = 0.0; };       // [points] or [1]
Spread spreadOf(const std::vector<double>& values);          // [any]

/// Five numbers of a box plot; quartiles by linear interpolation.
struct Quartiles { double least = 0.0, lower = 0.0, median = 0.0, upper = 0.0, most = 0.0; };   // [points]
Quartiles quartilesOf(std::vector<double> values);           // [points]

struct DelphiResult {
  std::vector<double> weight;                  // [1] mean over the experts of the last round used; sum 1
  std::vector<double> deviation;               // [1] in that round
  int round = 0;                               // first round in which no index spreads more than the limit, from 1; 0: none does
};
/// When no round agrees, the last one's numbers are given with round = 0.
DelphiResult delphi(const std::vector<DelphiRound>&, double limit);                    // limit [1]

struct SystemResult {
  std::string system;
  std::vector<Spread> index;                   // [points] of each index
  std::vector<Quartiles> quartiles;            // [points] of each index
  std::vector<double> objective;               // [1] beta_j, eq. 12; the subjective weights when nobody differs on anything
  std::vector<double> comprehensive;           // [1] omega_j, eq. 13
  std::vector<double> score;                   // [points] f_i of each rater, eq. 14
  Spread total;                                // [points] over the raters
};

SystemResult scoreSystem(const SystemScores&, const std::vector<double>& subjective, double preference);   // [1]

}  // namespace halsted::app
