#pragma once
/// The end of one stitch and the beginning of the next, as an explicit act (`Command::kFreshThread`, recorded with the step's input): the
/// surgeon's hands are empty, the stitch is tied and the needle is cut off; the assistant trims the tails, takes the rest of the thread
/// away and puts a needle with a new thread into the driver.
///
/// The scene has one strand, a chain that cannot leave in part. So its tied loop becomes a `TiedStitch` in that moment and not at the cut:
/// until then the surgeon may still hold the tails. The loop goes on through the same holes and pulls with the tension that the thread
/// had, or hangs as far as it hung; then the whole strand is laid anew, hanging from the driver, as at the scene's start. Tissue is not touched: no particle moves,
/// and what pulls on it changes only by the thread that lay on the wall and the turn of the thread at the holes. What is put elsewhere is
/// thread that nobody holds, in nothing, and the driver must be so far from the wall that the new thread hangs free. Physics thread; no heap.
#include "sim/suture/thread_supply.h"

namespace halsted {

struct Model;
struct State;
struct StepOutput;

/// Stitches that are tied and cut off, those kept and the running strand's; of two ends only what joins them: one half torn out is none.
int finishedStitches(const Model&, const State&);

/// Begins the step. Hands a thread, or says in an event and in `State::supply` why not.
void handFreshThread(const Model&, State&, StepOutput&);

}  // namespace halsted
