#pragma once
/// Pictures computed once, so that a pixel costs a lookup and not a formula. All tile; all deterministic.
#include <cstdint>
#include <vector>

namespace halsted::render {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

Image makeTissueImage(int size);      // r mottling, g fine vessels, b bumps, a gloss
/// What a mirror sees in each direction of the operating theatre, as a sphere map; colour = 4 rgb^2.
Image makeReflectionImage(int size);

}  // namespace halsted::render
