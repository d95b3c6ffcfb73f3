#pragma once
/// The wall with a stitch through it, and a surgeon on his way through a tie who can be stopped at any phase.
#include <gtest/gtest.h>

#include <string>

#include "scenes/expert_state.h"
#include "tests/scenes/tied_wall.h"

namespace halsted {

class Tying : public ::testing::Test {
 protected:
  explicit Tying(const std::string& throws) : script(tie("tie = \"" + throws + "\"")), memory(scenes::beginExpert(script, w.model)) {}

  TiedWall w;
  scenes::ExpertScript script;
  scenes::ExpertStatePtr memory;

  static scenes::ExpertScript tie(const std::string& keys) {
    return scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\n" + keys + "\nlimit_s = 60\n", "test");
  }
  void runTo(int phase) {
    for (int k = 0; k < 40000 && memory->phase != phase; ++k) ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
    ASSERT_EQ(memory->phase, phase);
  }
};

}  // namespace halsted
