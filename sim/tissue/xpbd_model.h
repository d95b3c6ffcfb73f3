#pragma once
/// Stable neo-Hookean XPBD (Macklin and Mueller 2021): two constraints per tet. Data built at load time.
#include <vector>

#include "sim/types.h"

namespace halsted {

struct XpbdModel {
  int substeps = 1;                            // [1] per dt, chosen so that the stiffness is true within 5 % (physics.md 0.7)
  std::vector<int> order;                      // sweep order of the tets
};

}  // namespace halsted
