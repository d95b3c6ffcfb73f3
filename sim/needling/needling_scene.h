#pragma once
/// The needled body as a kind of model: what `step`, `initialState` and the snapshot call for ModelKind::kNeedling. Physics thread.
#include "sim/step.h"

namespace halsted {

void beginNeedling(const Model&, State&);      // tools are where they start

/// One step of tools and tissue. Samples are numbers.
void stepNeedling(const Model&, const StepInput&, State&, StepOutput&);

/// After the step: strokes, metrics, and the quantities of the procedure table.
void measureNeedling(const Model&, const StepInput&, State&, StepOutput&);

void prepareNeedlingSnapshot(const Model&, RenderSnapshot&);
void fillNeedlingSnapshot(const Model&, const State&, RenderSnapshot&);

/// What the picture needs of the body once; nothing for another kind of model.
void describeBody(const Model&, RenderScene&);

}  // namespace halsted
