#pragma once
/// A finished picture: RGBA, 8 bits a channel, top row first, alpha always 255.
#include <cstdint>
#include <vector>

namespace halsted::render {

struct Frame {
  int width = 0, height = 0;                 // pixels
  std::vector<std::uint8_t> rgba;            // 4 * width * height
};

}  // namespace halsted::render
