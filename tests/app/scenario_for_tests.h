#pragma once
/// The shipped scene and its script, as the tests run them.
#include <string>
#include <vector>

#include "app/scenario.h"
#include "tests/support/source_folder.h"

namespace halsted::app {

inline std::string expertPath() { return testing::sourceFolder() + "/scenes/purse_string/expert.toml"; }
inline Scenario expertScenario(const std::vector<std::string>& overrides = {}) { return scenarioFromFile(expertPath(), overrides); }

}  // namespace halsted::app
