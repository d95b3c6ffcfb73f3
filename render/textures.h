#pragma once
/// Pictures computed once, so that a pixel costs a lookup and not a formula. All deterministic.
#include <array>
#include <cstdint>
#include <vector>

#include "render/color.h"

namespace halsted::render {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// A square whose texel at (x, y) is `pixel(x, y)`, four numbers from 0 to 1; asked row by row.
template <typename Pixel>
Image bake(int size, Pixel pixel) {
  Image image{size, size, {}};
  image.rgba.reserve(4u * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const std::array<double, 4> texel = pixel(x, y);                                // [1]
      for (const double channel : texel) image.rgba.push_back(byteOf(channel));       // [1]
    }
  return image;
}

Image makeTissueImage(int size);      // r mottling, g fine vessels, b bumps, a gloss; tiles
/// What a mirror sees in each direction of the operating theatre, as a sphere map; colour = 4 rgb^2.
Image makeReflectionImage(int size);

}  // namespace halsted::render
