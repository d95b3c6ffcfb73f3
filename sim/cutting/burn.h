#pragma once
/// The electrocautery pen. While its hand is closed and its electrode touches tissue, its power goes into the tets within reach of the
/// electrode, each by how near it is; nothing but the place of the tip decides. A tet that can be cut is gone once it has taken up what
/// boils it away; one that cannot is only charred. No heat flows on and none is lost: at 30 W a cut passes a place in a tenth of a second,
/// in which heat creeps 0.1 mm (diffusivity of soft tissue 1.4e-7 m^2/s), less than a tet. Physics thread; no heap.

namespace halsted {

struct Model;
struct State;
struct StepOutput;

/// First thing in a step: heat, what it takes away, and what no longer holds because of it. Nothing where nothing can be cut.
void cutTissue(const Model&, State&, StepOutput&);

/// For the picture: is this hand's pen switched on where tissue is charred? It smokes on when current has just burnt a gap before it.
bool smokes(const Model&, const State&, int hand);

}  // namespace halsted
