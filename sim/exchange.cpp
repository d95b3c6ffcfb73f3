#include "sim/exchange.h"

namespace halsted {

const char* name(EventKind kind) {
  switch (kind) {
    case EventKind::kNeedleEntered: return "needle entered";
    case EventKind::kNeedleExited: return "needle exited";
    case EventKind::kBiteCompleted: return "bite completed";
    case EventKind::kNeedleGrasped: return "needle grasped";
    case EventKind::kNeedleReleased: return "needle released";
    case EventKind::kThreadGrasped: return "thread grasped";
    case EventKind::kThreadReleased: return "thread released";
    case EventKind::kTissueGrasped: return "tissue grasped";
    case EventKind::kTissueReleased: return "tissue released";
    case EventKind::kChannelTorn: return "channel torn";
    case EventKind::kChannelEmptied: return "channel emptied";
    case EventKind::kStepDone: return "step done";
    case EventKind::kFault: return "fault";
    case EventKind::kStepLate: return "step takes too long";
    case EventKind::kBegunAnew: return "begun anew";
    case EventKind::kProcedureCompleted: return "procedure completed";
    case EventKind::kThreadBroken: return "thread broken";
    case EventKind::kThreadCut: return "thread cut";
    case EventKind::kThrowTied: return "throw tied";
    case EventKind::kStitchFinished: return "stitch finished";
    case EventKind::kThreadHanded: return "fresh thread handed";
    case EventKind::kThreadRefused: return "no thread handed";
    case EventKind::kInstrumentChanged: return "instrument changed";
    case EventKind::kInstrumentRefused: return "instrument not changed";
    case EventKind::kThrowLost: return "throw lost";
    case EventKind::kLayerPunctured: return "layer punctured";
    case EventKind::kTissueCut: return "tissue cut";
    case EventKind::kPieceFree: return "piece free";
    case EventKind::kPieceTaken: return "piece taken away";
    case EventKind::kClampHandedOver: return "clamp handed over";
    case EventKind::kClampRefused: return "clamp not taken over";
    case EventKind::kClampReleased: return "assistant's clamp let go";
    case EventKind::kWallPerforated: return "wall perforated by the instrument";
  }
  return "unknown event";
}

const char* name(ToolKind kind) {
  switch (kind) {
    case ToolKind::kNeedleDriver: return "needle_driver";
    case ToolKind::kForceps: return "forceps";
    case ToolKind::kAcupunctureNeedle: return "acupuncture_needle";
    case ToolKind::kFinger: return "finger";
    case ToolKind::kNone: return "none";
    case ToolKind::kElectrocautery: return "electrocautery";
    case ToolKind::kAllis: return "allis";
  }
  return "unknown";
}

}  // namespace halsted
