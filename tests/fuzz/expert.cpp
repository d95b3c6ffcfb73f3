/// Any bytes as a surgeon's script.
#include <cstdint>

#include "scenes/expert.h"
#include "tests/fuzz/accepted.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halsted;
  const std::string text(reinterpret_cast<const char*>(data), size);
  fuzz::accepted([&] { scenes::parseExpert(text, "fuzz.toml"); });
  return 0;
}
