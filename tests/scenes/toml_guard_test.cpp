/// A key of very many parts would nest the tables of a file deeper than the stack is: it is refused before it is read.
#include <gtest/gtest.h>

#include "scenes/expert.h"
#include "scenes/scene.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

using testing::expectRefused;

void parseGuarded(const std::string& text) { scenes::parseScene("title = \"t\"\n" + text, "test.toml", "/tmp/test_scene", {}); }

/// `first`, then `part` so many times.
std::string repeated(const std::string& part, int times, std::string first = {}) {
  std::string text = std::move(first);
  for (int i = 0; i < times; ++i) text += part;
  return text;
}

TEST(TomlGuard, RefusesAKeyOfVeryManyParts) {
  for (int parts : {70, 100'000}) {
    const std::string dotted = repeated(".a", parts, "a"), quoted = repeated(" . 'a'", parts, "\"a b\"");
    expectRefused([&] { parseGuarded(dotted + " = 1"); }, {"test.toml:2: ", "a key of more than 64 parts"});
    expectRefused([&] { parseGuarded("[" + dotted + "]"); }, {"test.toml:2: ", "a key of more than 64 parts"});
    expectRefused([&] { parseGuarded("[[" + dotted + "]]"); }, {"test.toml:2: ", "a key of more than 64 parts"});
    expectRefused([&] { parseGuarded("x = { " + dotted + " = 1 }"); }, {"test.toml:2: ", "a key of more than 64 parts"});
    expectRefused([&] { parseGuarded(quoted + " = 1"); }, {"test.toml:2: ", "a key of more than 64 parts"});
    expectRefused([&] { scenes::parseExpert(dotted + " = 1", "e.toml"); }, {"e.toml:1: ", "a key of more than 64 parts"});
  }
}

/// Key in key, list in list: what each line alone may have adds up.
TEST(TomlGuard, RefusesNestingOverManyKeys) {
  std::string text = "x = ";
  for (int i = 0; i < 200; ++i) text += "[\n{ a" + repeated(".a", 60) + " = ";
  expectRefused([&] { parseGuarded(text + "1"); }, {"test.toml:"});
}

TEST(TomlGuard, CountsNoDotsOfTextsCommentsAndNumbers) {
  const std::string dots = repeated(".", 1000);
  expectRefused([&] { parseGuarded("technique = \"" + dots + "\" # " + dots + "\n[anvil]\nfrom = [" + repeated("0.1, ", 100) + "]\n"); },
                {"anvil.from: must be a list of three numbers"});
}

}  // namespace
}  // namespace halsted
