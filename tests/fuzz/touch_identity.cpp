/// Any bytes as what a Touch says about itself: frames of at most 255 bytes and printable text.
#include <cstdint>
#include <cstdlib>

#include "haptics/touch/touch_identity.h"

using namespace halsted::haptics;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  TouchFramer framer;
  for (std::size_t i = 0; i < size; ++i) {
    const auto frame = framer.push(data[i]);
    if (!frame) continue;
    if (frame->payload.size() > 255) std::abort();
    for (const char c : printableText(frame->payload))
      if (c < 0x20 || c >= 0x7f) std::abort();
  }
  return 0;
}
