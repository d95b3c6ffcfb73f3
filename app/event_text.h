#pragma once
/// What happened, in the words of the scene: for the picture's banner and the list of faults. Any thread but physics and haptics (heap).
#include <span>
#include <string>

#include "sim/exchange.h"
#include "sim/procedure.h"

namespace halsted::app {

/// Of a fault its name, of a step that is late its limit, of what the assistant refuses the reason, of a wall that is gone through the force; else what the event is called.
std::string eventText(const Event&, std::span<const ProcedureStep>);

bool isFault(EventKind);                      // the scene's own, or that a step is late
bool isGrave(EventKind);                      // a fault, or something of the patient's has torn

/// The same without the word "fault" before it; only where isFault.
std::string faultText(EventKind, const ProcedureStep&);

}  // namespace halsted::app
