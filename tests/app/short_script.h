#pragma once
/// A script of a fifth of a second: for what needs a run, not what happens in it.
#include <string>

#include "tests/support/process.h"

namespace halsted::app {

/// Written to `folder`; its path.
inline std::string writeShortScript(const halsted::testing::TemporaryFolder& folder) {
  const std::string path = folder.file("short.toml");
  halsted::testing::writeText(path, "scene = \"purse_string\"\n\n[[action]]\ndo = \"hold\"\nlimit_s = 0.2\n");
  return path;
}

}  // namespace halsted::app
