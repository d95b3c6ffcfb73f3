#pragma once
/// How far the thread may move in one step while it touches itself. A contact is known by its direction at the start of a step, so no
/// node may stray from the path of inertia by more than a share of the thread's width. A wire that weighs 50 mg a metre does, when it
/// snaps: a millimetre of curl straightens in 50 us. Such a step is solved again with a drag of neighbouring nodes on each other, as the
/// internal friction of a braid would have it; it fades when the snap is over. It only dissipates, holds back nothing that moves as a whole
/// (a drag against space would: what draws at the thread would tear it), and is limited: thread that strays even so is taken as it is.
#include "sim/strand/strand.h"
#include "sim/strand/thread_contacts.h"

namespace halsted {

/// Finds the contacts; lets the drag fade; remembers what a second attempt begins with.
void beginTouch(const StrandModel&, const StrandState&, double dt, ThreadTouch&);   // [s]

/// Whether the last Newton correction is still large beside the thread's width, where it touches, or a hand's. Contacts open and close between iterates.
bool stillMoving(const StrandModel&, const std::vector<double>& correction, const ThreadContactWork&);   // [m]

/// Whether the step must be solved again more slowly; then the drag is raised and the tensions are set back.
bool mustSlow(const StrandModel&, StrandState&, const StrandWork&, bool settled, ThreadTouch&);

/// The drag's forces and stiffness at an iterate, into the strand's system.
void assembleSnapDrag(const StrandModel&, const StrandState& start, double dt, const ThreadTouch&, StrandWork&);   // [s]

}  // namespace halsted
