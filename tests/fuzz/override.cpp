/// Any lines as `--set` arguments.
#include <cstdint>
#include <sstream>

#include "tests/fuzz/accepted.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halsted;
  std::istringstream lines(std::string(reinterpret_cast<const char*>(data), size));
  std::vector<std::string> overrides;
  for (std::string line; std::getline(lines, line);) overrides.push_back(line);
  fuzz::accepted([&] { scenes::parseScene("title = \"t\"", "fuzz.toml", "/nonexistent/scene", overrides, scenes::PathTrust::kFile); });
  return 0;
}
