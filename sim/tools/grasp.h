#pragma once
/// What closing and opening the jaws does: needle, thread or tissue that lies between them is held. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

/// Takes over the sample's pose and jaw; grasps on closing, releases on opening.
void moveTool(const Model&, int hand, const ToolSample&, State&, StepOutput&);

/// Links of needle and thread held by the jaws; remembers their place in the link table.
struct GraspLinks { int needle = -1, thread = -1; };
GraspLinks linkGrasp(const Model&, int hand, State&);
/// After the strand's solve: forces on the tool; the thread slips out above the grip.
void settleGrasp(const Model&, int hand, const GraspLinks&, State&, StepOutput&);

/// Tissue that the grip could not hold has slid through the jaws: it is held where it lies now, and what slid out is let go.
/// After the tissue has answered to the grasp's forces; before the tool moves on.
void slipGrasp(const Model&, int hand, State&, StepOutput&);

/// The same for any jaws: what lies past their hold is held where it lies now. True when some has left them, and its force is taken back.
bool slideThroughJaws(const Model&, const ToolParams&, const Pose& jaws, TissueGrasp&, State&);

/// Of the tissue on the jaws that hold it.  [N]
Vec3 graspForce(const TissueGrasp&);

/// Takes one held point of tissue out of the list, or all of them with their forces.
void dropGraspPoint(TissueGrasp&, int point);
void letGoOfTissue(const Model&, TissueGrasp&, State&);

/// Total force on the hand and the proxy that follows from it: proxy = device + lag + force / coupling.
void updateProxy(const Model&, int hand, State&);

}  // namespace halsted
