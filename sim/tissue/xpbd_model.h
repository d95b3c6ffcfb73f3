#pragma once
/// Stable neo-Hookean XPBD (Macklin and Mueller 2021): two constraints per tet, solved together. Data built at load time.
#include <vector>

#include "sim/lane_math.h"
#include "sim/line_vector.h"
#include "sim/types.h"

namespace halsted {

struct TissueModel;
struct TissueParams;

struct XpbdModel {
  static constexpr int kLanes = 4;
  int substeps = 1;                            // [1] per dt, chosen so that the stiffness is true within 5 % (physics.md 0.7)
  double stiffnessShortfall = 0.0;             // [1] expected extra stretch under load: 0.05 = 5 % softer than E says
  std::vector<int> order;                      // sweep order of the tets: by colour, then index; tets of a colour share no particle
  // The same tets in groups of four within a colour; a colour's last group repeats its last tet, which writes the same bits twice.
  int groups = 0;
  std::vector<int> laneVertex;                 // [group][corner][lane]
  LineVector<double> laneRestInverse;          // [1/m] [group][9][lane], row-major
  LineVector<double> laneInverseVolume;        // [1/m^3] [group][lane]
  std::vector<int> laneTet;                    // [group][lane]
  LanePath path = LanePath::kSerial;           // set by the builder to the widest the CPU has
};

/// Fills `model.xpbd`; needs masses, fixed flags, rest inverses and volumes. `substeps` 0: as many as the stiffness promise needs,
/// up to a limit; what is still missing stands in `stiffnessShortfall`.
void buildXpbd(TissueModel& model, const TissueParams&);

}  // namespace halsted
