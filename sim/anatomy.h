#pragma once
/// What a scene operates on: a wall of tetrahedra, or a body of nested closed surfaces. The other one is empty.
#include "sim/mesh.h"
#include "sim/needling/body.h"

namespace halsted {

struct Anatomy {
  TetMesh mesh;
  Body body;
};

}  // namespace halsted
