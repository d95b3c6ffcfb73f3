#pragma once
/// What lies around the organ: wound with fat, moist abdominal pads, folded drapes; round a prolapse the skin. Nothing moves, so shape, light and colour are
/// baked once; only the shadow of what moves is added per frame.
#include "render/shape.h"
#include "render/textures.h"

namespace halsted::render {

/// Where the organ comes out of the wound.
struct FieldPlace {
  Vec3 centre = Vec3::Zero();                // [m] on the skin's plane, which faces +z
  double radius = 0.02;                      // [m] of the organ there
  bool perineum = false;                     // the organ comes out of the anus: no wound and no pads
};

constexpr double kFieldHalfSize = 0.17;      // [m] half the side of the baked square
constexpr int kFieldCells = 80;              // a side of the grid it is drawn with

struct OperatingField {
  Shape shape;
  Image picture;                             // rgb: square root of lit linear colour; a: 0 drape, 0.5 pad, 1 wound
};

OperatingField makeOperatingField(const FieldPlace&, int pictureSize);

}  // namespace halsted::render
