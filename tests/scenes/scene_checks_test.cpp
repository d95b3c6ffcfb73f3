/// Of values that do not fit together the one is named that was set last.
#include <gtest/gtest.h>

#include "scenes/scene.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

using testing::expectRefused;

void parseChecked(const std::string& text, const std::vector<std::string>& overrides) { scenes::parseScene("title = \"t\"\n" + text, "test.toml", "/tmp/test_scene", overrides); }

TEST(SceneChecks, NameWhatTheUserSetBeforeWhatTheFileSays) {
  const std::string text = "[anatomy]\nwall = 2e-3\nradius = 18e-3\naround = 34\nalong = 18\n[thread]\nnodes = 100\nsegment_length = 2e-3\n";
  expectRefused([&] { parseChecked(text, {"anatomy.radius=2.2e-3"}); }, {"--set anatomy.radius=2.2e-3: wall and haustra_depth"});
  expectRefused([&] { parseChecked(text, {"thread.nodes=2000"}); }, {"--set thread.nodes=2000: the thread is longer"});
  expectRefused([&] { parseChecked(text + "[camera]\nup = [0, 1, 0]\n", {"camera.target=[0, 0.1, 0]", "camera.eye=[0, 0.2, 0]"}); }, {"--set camera.eye="});
}

}  // namespace
}  // namespace halsted
