#pragma once
/// The prolapse that the tests of scenes/ look at: as scenes/altemeier has it.
#include "sim/params.h"

namespace halsted {

inline AnatomyParams prolapsed() {
  AnatomyParams a;
  a.layout = "prolapse";
  a.length = 45e-3;
  a.radius = 22e-3;
  a.wall = 2.5e-3;
  a.gap = 4e-3;
  a.around = 36;
  a.along = 37;
  return a;
}

/// With a pen in the right hand.
inline SimParams penAndProlapse() {
  SimParams p;
  p.anatomy = prolapsed();
  p.tools[kRight].kind = ToolKind::kElectrocautery;
  return p;
}

}  // namespace halsted
