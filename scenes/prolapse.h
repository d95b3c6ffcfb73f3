#pragma once
/// A full-thickness rectal prolapse without a data file: bowel turned inside out through the anus stands toward the surgeon as two walls,
/// one in the other. The outer one has its mucosa outside, the inner one as any bowel round its lumen; serosa faces serosa between them,
/// and at the tip one goes over into the other. Deterministic to the bit.
#include <vector>

#include "sim/mesh.h"
#include "sim/params.h"

namespace halsted::scenes {

/// What a prolapse's wall is swept along: half a section through the axis, from the inner wall's base over the tip to the outer wall's.
struct ProlapseProfile {
  std::vector<double> along;                   // [m] of each row from the inner base, on the middle of the wall
  std::vector<double> fromLine;                // [m] of each row to the line of its own wall, positive toward the base
  int firstOuterRow = 0;                       // rows before it are the inner wall
  std::array<int, 2> lineRow{};                // of the outer [0] and the inner [1] wall: last row on the base's side of its line
  double straight = 0.0, whole = 0.0;          // [m] one wall up to the fold; both walls and the fold
};
ProlapseProfile prolapseProfile(const AnatomyParams&);

/// Axis +z, the tip 0.6 of the length in front of the origin, both bases behind it and fixed. The wall is one structured grid: rows from the
/// inner base over the tip to the outer base, finer (kCutRow) within `cut_band` of the planned line, which lies `cut_height` from the
/// base on both walls. Bowel 0 is the outer wall, bowel 1 the inner; rims are the rows next to the line on the base's side, what is sewn
/// after the cut; `uv.y` is the distance to the line, positive toward the base. `params` are taken as checked by the scene reader.
TetMesh prolapse(const AnatomyParams& params);

/// The same with the cross-section of a real bowel: `section` is how far its wall is from its middle in each of `around` directions, over the mean. What lies
/// between the walls goes in and out with it; thickness, gap and height stay. Throws InputError where that leaves no lumen.
TetMesh prolapse(const AnatomyParams& params, const std::vector<double>& section);   // [1]

/// Of a tube's wall (scenes/tube.h), the mean over its length.
std::vector<double> crossSection(const TetMesh& tube, const AnatomyParams&);         // [1]

inline constexpr double kCutRow = 1e-3;        // [m] a row of tets: as wide as what a blade tip burns away

/// Least that the walls may be long beyond the cuttable band: the rest of the specimen.  [m]
inline constexpr double kLeastSpecimen = 8e-3;
double foldHeight(const AnatomyParams&);       // [m] of the tip over the end of the straight walls

}  // namespace halsted::scenes
