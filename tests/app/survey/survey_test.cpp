/// Law S9: the scoring reproduces the paper's weights and the scores it was given; bad tables are one line each. The real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/survey/score.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

using halsted::testing::ProcessResult;
using halsted::testing::TemporaryFolder;
using halsted::testing::writeText;
using ::testing::HasSubstr;

constexpr double kTableThree[7] = {0.17, 0.24, 0.13, 0.10, 0.21, 0.06, 0.09};                 // [1]
constexpr double kTableFour[5][7] = {                                                         // [1]
    {0.097, 0.041, 0.210, 0.204, 0.083, 0.282, 0.084}, {0.116, 0.163, 0.211, 0.023, 0.120, 0.281, 0.087},
    {0.124, 0.186, 0.200, 0.058, 0.142, 0.216, 0.073}, {0.097, 0.287, 0.107, 0.148, 0.067, 0.163, 0.132},
    {0.159, 0.096, 0.195, 0.116, 0.200, 0.102, 0.133}};
constexpr const char* kSystems[5] = {"MSM", "FEM", "BEM", "SHF", "Ours"};
constexpr double kMeans[5] = {7.83, 7.90, 7.93, 7.88, 8.94};                                  // [points]
const std::string kIds = "soft_tissue_material,force_feedback,acupuncture_effect,training_environment,real_time,training_effect,system_stability";

/// Sixteen raters whose scores spread as table 4 says round the published mean: half a step above, half below.
double synthetic(int system, int rater, int index) {         // [points]
  const double side = ((rater >> (index % 4)) + index) % 2 ? 1.0 : -1.0;   // [1]
  return kMeans[system] + side * 2.0 * kTableFour[system][index];
}

std::string csvOfAll() {
  std::string text = "system,rater," + kIds + "\n";
  for (int s = 0; s < 5; ++s)
    for (int r = 0; r < 16; ++r) {
      text += std::string(kSystems[s]) + ",doctor " + std::to_string(r);
      for (int j = 0; j < 7; ++j) (text += ",") += std::to_string(synthetic(s, r, j));
      text += "\n";
    }
  return text;
}

ProcessResult score(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {HALSTED_BINARY, "survey", "score"});
  return halsted::testing::run(arguments);
}

TEST(Survey, ReproducesTablesThreeAndFourAndTheMeans) {
  const TemporaryFolder folder;
  writeText(folder.file("scores.csv"), csvOfAll());
  const ProcessResult result = score({folder.file("scores.csv"), "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["mu"], 0.4);
  for (int j = 0; j < 7; ++j) EXPECT_NEAR(json["subjective_weights"][j], kTableThree[j], 1e-12);
  for (int s = 0; s < 5; ++s) {
    const auto& system = json["systems"][s];
    double sum = 0.0, total = 0.0, columns = 0.0;            // [1]
    for (double w : kTableFour[s]) columns += w;             // 0.999 to 1.001 in print
    for (int j = 0; j < 7; ++j) {
      const double objective = system["indices"][j]["objective_weight"], comprehensive = system["indices"][j]["comprehensive_weight"];   // [1]
      EXPECT_NEAR(objective, kTableFour[s][j] / columns, 1e-6);
      EXPECT_NEAR(comprehensive, 0.4 * kTableThree[j] + 0.6 * objective, 1e-12);
      sum += objective;
      total += comprehensive;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(total, 1.0, 1e-12);
    EXPECT_NEAR(system["mean"], kMeans[s], 1e-6);            // weights that sum to 1 keep a common mean
    EXPECT_GT(system["deviation"], 0.0);
    for (int r = 0; r < 16; ++r) {                           // eq. 14, rater by rater
      double expected = 0.0;                                 // [points]
      for (int j = 0; j < 7; ++j) expected += system["indices"][j]["comprehensive_weight"].get<double>() * synthetic(s, r, j);
      EXPECT_NEAR(system["scores"][r], expected, 1e-5);
    }
  }
}

TEST(Survey, DelphiStopsInTheFirstRoundThatAgrees) {
  const std::vector<DelphiRound> rounds{{{{0.9, 0.1}, {0.3, 0.7}}}, {{{0.6, 0.4}, {0.4, 0.6}}}, {{{0.5, 0.5}, {0.5, 0.5}}}};
  const DelphiResult result = delphi(rounds, 0.1);
  EXPECT_EQ(result.round, 2);                  // 0.3 in round 1, 0.1 in round 2
  EXPECT_NEAR(result.weight[0], 0.5, 1e-12);
  EXPECT_NEAR(result.deviation[0], 0.1, 1e-12);
  EXPECT_EQ(delphi({rounds[0]}, 0.1).round, 0);
}

TEST(Survey, DelphiTableReplacesTheWeights) {
  const TemporaryFolder folder;
  writeText(folder.file("scores.csv"), csvOfAll());
  writeText(folder.file("experts.csv"), "round,expert," + kIds + "\n1,a,0.4,0.1,0.1,0.1,0.1,0.1,0.1\n1,b,0.0,0.5,0.1,0.1,0.1,0.1,0.1\n"
                                        "2,a,0.2,0.3,0.1,0.1,0.1,0.1,0.1\n2,b,0.1,0.4,0.1,0.1,0.1,0.1,0.1\n");
  const ProcessResult result = score({folder.file("scores.csv"), "--delphi", folder.file("experts.csv"), "--json", "--mu", "1"});
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["delphi_round"], 2);
  EXPECT_NEAR(json["subjective_weights"][0], 0.15, 1e-12);
  EXPECT_NEAR(json["systems"][0]["indices"][1]["comprehensive_weight"], 0.35, 1e-12);
}

TEST(Survey, TheExitSurveyIsAnotherQuestionnaire) {
  const TemporaryFolder folder;
  writeText(folder.file("exit.csv"), "rater,system,q1,q2,q3,q4,q5\r\nA,ours,4,4,5,3,5\r\nB,ours,5,4,4,3,4\r\nC,ours,3,4,4,3,5\r\n");
  const ProcessResult result = score({folder.file("exit.csv"), "--questionnaire", "rectal_prolapse", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_NEAR(json["systems"][0]["mean"], 4.0, 1e-12);       // every question counts the same
  EXPECT_EQ(json["systems"][0]["indices"][0]["box"], nlohmann::json({3.0, 3.5, 4.0, 4.5, 5.0}));
  const ProcessResult text = score({folder.file("exit.csv"), "--questionnaire", "rectal_prolapse"});
  EXPECT_THAT(text.output, HasSubstr("final score"));
}

void expectRefused(const std::vector<std::string>& arguments, const std::string& mentions) {
  const ProcessResult result = score(arguments);
  EXPECT_EQ(result.exitCode, 2) << mentions;
  EXPECT_THAT(result.errors, HasSubstr(mentions));
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
}

TEST(Survey, BadTablesAreOneLineEach) {
  const TemporaryFolder folder;
  const std::string file = folder.file("scores.csv"), head = "system,rater," + kIds + "\n";
  const auto refused = [&](const std::string& text, const std::string& mentions) {
    writeText(file, text);
    expectRefused({file}, mentions);
  };
  refused(head + "A,1,5,5,5,5,5,5,5\nA,2,5,5,5,11,5,5,5\n", "scores.csv:3: training_environment: 11 is outside the scale 0 to 10");
  refused(head + "A,1,5,5,5,5,5,5,5\nA,2,5,5,-1,5,5,5,5\n", "outside the scale");
  refused(head + "A,1,5,5,5,5,5,5,5\nA,2,5,,5,5,5,5,5\n", "scores.csv:3: force_feedback: is missing");
  refused(head + "A,1,5,5,5,5,5,5,5\nA,2,5,good,5,5,5,5,5\n", "good is not a number");
  refused(head + "A,1,5,5,5,5,5,5,5\nA,2,5,nan,5,5,5,5,5\n", "is not a number");
  refused(head + "A,1,5,5,5,5,5,5,5\nA,2,5,5,5,5,5,5\n", "8 fields, the header has 9");
  refused(head + "A,1,5,5,5,5,5,5,5\nA,1,5,5,5,5,5,5,5\n", "a second time");
  refused(head + "A,1,5,5,5,5,5,5,5\nA,2,5,5,5,5,5,5,5\nB,1,5,5,5,5,5,5,5\n", "rater 2 did not score system B");
  refused(head + "A,1,5,5,5,5,5,5,5\nB,2,5,5,5,5,5,5,5\n", "rater 2 did not score system A");
  refused(head + "A,1,5,5,5,5,5,5,5\n", "only one rater");
  refused(head, "no rows");
  refused("", "no rows");
  refused("system,rater,colour\nA,1,5\n", "no column soft_tissue_material");
  refused("system,rater,colour," + kIds + "\nA,1,5,5,5,5,5,5,5,5\n", "column colour is none of the questionnaire's");
  refused(head + "\"A,1,5,5,5,5,5,5,5\n", "a quote is not closed");
  expectRefused({folder.file("none.csv")}, "no such file");
}

TEST(Survey, BadQuestionnairesAndExpertsAreOneLineEach) {
  const TemporaryFolder folder;
  const std::string scores = folder.file("scores.csv"), toml = folder.file("q.toml"), experts = folder.file("experts.csv");
  writeText(scores, csvOfAll());
  for (const auto& [text, mentions] : {std::pair<std::string, std::string>{"scale = [5, 1]\n", "highest must be above"},
                                       {"title = \"x\"\n", "no [[index]]"}, {"colour = 3\n", "unknown key"},
                                       {"[[index]]\ntext = \"x\"\n", "has no id"}, {"mu = 2\n", "between 0 and 1"},
                                       {"[[index]]\nid = \"a\"\n[[index]]\nid = \"a\"\n", "appears twice"},
                                       {"[[index]]\nid = \"a\"\nweight = 0.4\n", "add up to 0.4"},
                                       {"[[index]]\nid = \"a\"\nweight = 1\n[[index]]\nid = \"b\"\n", "all indices need one"}}) {
    writeText(toml, text);
    expectRefused({scores, "--questionnaire", toml}, mentions);
  }
  expectRefused({scores, "--questionnaire", "nowhere"}, "nowhere");
  const std::string head = "round,expert," + kIds + "\n";
  for (const auto& [text, mentions] : {std::pair<std::string, std::string>{head + "1,a,0.5,0.1,0.1,0.1,0.1,0.1,0.1\n", "add up to 1.1"},
                                       {head + "2,a,0.4,0.1,0.1,0.1,0.1,0.1,0.1\n", "rounds count from 1"},
                                       {head + "1,a,0.4,0.1,0.1,0.1,0.1,0.1,0.1\n1,b,0.0,0.5,0.1,0.1,0.1,0.1,0.1\n", "ask the experts again"},
                                       {head + "1,a,1.4,-0.9,0.1,0.1,0.1,0.1,0.1\n", "between 0 and 1"}}) {
    writeText(experts, text);
    expectRefused({scores, "--delphi", experts}, mentions);
  }
}

}  // namespace
}  // namespace halsted::app
