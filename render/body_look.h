#pragma once
/// Colours, texture and shaders of a needled body and of the hands over it.
#include "render/textures.h"
#include "sim/types.h"

namespace halsted::render {

constexpr double kBodyTile = 24e-3;                      // [m] a side of the body's texture
/// Linear reflectance of skin without and with blood near the surface. tuned: looked at beside photographs of forearms.
const Vec3 kSkinPale(0.60, 0.385, 0.275), kSkinRosy(0.585, 0.325, 0.235);   // [1]

/// r: relief of skin, 0 in its furrows; g: lobules of fat, 0 in the septa; b: muscle fibres along the first axis; a: mottling. Tiles.
Image makeBodyImage(int size);

extern const char* const kSkinFragment;                  // after one of these two lines
extern const char* const kWithShadow;
extern const char* const kWithoutShadow;                 // for kFieldFragment to darken where a shadow may fall
extern const char* const kSectionFragment;               // fat, muscle and what a cut bares; vColor.a: 0 fat, 0.35 fascia over muscle, 0.65 muscle, 1 dermis
extern const char* const kHandleFragment;                // wound with steel and copper wire, so that a turn is seen
extern const char* const kSheetFragment;                 // what the body lies on
extern const char* const kMarkFragment;                  // a skin marker's ring or dot

}  // namespace halsted::render
