#include "scenes/knot_plan.h"

namespace halsted::scenes {

std::vector<PlannedThrow> parseThrows(const std::string& notation) {
  constexpr std::size_t kMostThrows = 8;
  std::vector<PlannedThrow> throws;
  int over = 1;
  for (std::size_t i = 0; i < notation.size(); ++i) {
    if (i % 2 == 1) {
      if (notation[i] != '=' && notation[i] != 'x') return {};
      if (notation[i] == 'x') over = -over;
    } else {
      if (notation[i] < '1' || notation[i] > '3') return {};
      throws.push_back({notation[i] - '0', over});
    }
  }
  return notation.size() % 2 == 0 || throws.size() > kMostThrows ? std::vector<PlannedThrow>{} : throws;
}

}  // namespace halsted::scenes
