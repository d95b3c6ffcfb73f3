#pragma once
/// The solids that touch tissue and strand: two jaws and a shaft per tool, and the fixed rod. Capsules in the world.
#include <array>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

inline constexpr int kSolidsPerTool = 3;                       // jaw at +x, jaw at -x, shaft
inline constexpr int kSolids = kSolidsPerTool * kHands + 1;    // and the anvil rod, last
inline constexpr int kRod = kSolids - 1;
inline constexpr int solidHand(int solid) { return solid == kRod ? -1 : solid / kSolidsPerTool; }

/// Capsules of one tool in the tool frame at a jaw opening [1]. Closed jaws touch at x = 0.
std::array<CapsuleShape, kSolidsPerTool> toolCapsules(const ToolParams&, double jaw);

/// All solids in the world at the tools' proxies.
std::array<CapsuleShape, kSolids> worldSolids(const Model&, const State&);

/// Is a vertex of tissue that can be touched within this capsule?
bool tissueWithin(const Model&, const State&, const CapsuleShape&);

/// Would the tool, placed here, overlap a surface near it (ToolState::nearTriangle)?
bool liesInTissue(const Model&, int hand, const Pose&, const State&);

CapsuleShape placed(const CapsuleShape&, const Pose&);

}  // namespace halsted
