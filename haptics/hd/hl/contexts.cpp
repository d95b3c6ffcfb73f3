/// HL: contexts, state, shapes, effects. There is no haptic rendering behind this interface, and it says so: no context can be made, and
/// what needs one raises HL_INVALID_OPERATION and touches nothing.
#include <cstdio>

#include "haptics/hd/hl/errors.h"

using halsted::haptics::hl::popError;
using halsted::haptics::hl::raise;

namespace {

void needsContext() { raise(HL_INVALID_OPERATION); }

HLboolean no() {
  needsContext();
  return HL_FALSE;
}

HLuint none() {
  needsContext();
  return 0;
}

}  // namespace

extern "C" {

HHLRC hlCreateContext(HHD hHD) {
  static const int said = std::fputs("halsted HL: haptic rendering of shapes and effects is not provided; HD is\n", stderr);
  static_cast<void>(said);
  raise(HL_DEVICE_ERROR, {HD_INVALID_OPERATION, 0, hHD});
  return nullptr;
}

void hlDeleteContext(HHLRC hHLRC) {
  if (hHLRC) needsContext();
}
void hlMakeCurrent(HHLRC hHLRC) {
  if (hHLRC) needsContext();
}
void hlContextDevice(HHD) { needsContext(); }
HHLRC hlGetCurrentContext(void) { return nullptr; }
HHD hlGetCurrentDevice(void) {
  needsContext();
  return HD_INVALID_HANDLE;
}
void hlBeginFrame(void) { needsContext(); }
void hlEndFrame(void) { needsContext(); }

HLerror hlGetError(void) { return popError(); }

void hlEnable(HLenum) { needsContext(); }
void hlDisable(HLenum) { needsContext(); }
HLboolean hlIsEnabled(HLenum) { return no(); }
void hlGetBooleanv(HLenum, HLboolean*) { needsContext(); }
void hlGetDoublev(HLenum, HLdouble*) { needsContext(); }
void hlGetIntegerv(HLenum, HLint*) { needsContext(); }

/// What the library is can be asked without a context.
const HLubyte* hlGetString(HLenum name) {
  if (name == HL_VENDOR) return reinterpret_cast<const HLubyte*>("Halsted (HL is not provided)");
  if (name == HL_VERSION) return reinterpret_cast<const HLubyte*>("3.30.0");
  raise(HL_INVALID_ENUM);
  return nullptr;
}

void hlHinti(HLenum, HLint) { needsContext(); }
void hlHintb(HLenum, HLboolean) { needsContext(); }
void hlPushAttrib(HLbitfield) { needsContext(); }
void hlPopAttrib(void) { needsContext(); }
HLboolean hlDeploymentLicense(const char*, const char*, const char*) { return HL_TRUE; }
void hlCacheGetBooleanv(HLcache*, HLenum, HLboolean*) { needsContext(); }
void hlCacheGetDoublev(HLcache*, HLenum, HLdouble*) { needsContext(); }

HLuint hlGenShapes(HLsizei) { return none(); }
void hlDeleteShapes(HLuint, HLsizei) { needsContext(); }
HLboolean hlIsShape(HLuint) { return no(); }
void hlBeginShape(HLenum, HLuint) { needsContext(); }
void hlEndShape(void) { needsContext(); }
void hlGetShapeBooleanv(HLuint, HLenum, HLboolean*) { needsContext(); }
void hlGetShapeDoublev(HLuint, HLenum, HLdouble*) { needsContext(); }
void hlLocalFeature1fv(HLgeom*, HLenum, const HLfloat*) { needsContext(); }
void hlLocalFeature1dv(HLgeom*, HLenum, const HLdouble*) { needsContext(); }
void hlLocalFeature2fv(HLgeom*, HLenum, const HLfloat*, const HLfloat*) { needsContext(); }
void hlLocalFeature2dv(HLgeom*, HLenum, const HLdouble*, const HLdouble*) { needsContext(); }
void hlMaterialf(HLenum, HLenum, HLfloat) { needsContext(); }
void hlGetMaterialfv(HLenum, HLenum, HLfloat*) { needsContext(); }
void hlTouchableFace(HLenum) { needsContext(); }
void hlTouchModel(HLenum) { needsContext(); }
void hlTouchModelf(HLenum, HLfloat) { needsContext(); }
void hlCallback(HLenum, HLcallbackProc, void*) { needsContext(); }

HLuint hlGenEffects(HLsizei) { return none(); }
void hlDeleteEffects(HLuint, HLsizei) { needsContext(); }
HLboolean hlIsEffect(HLuint) { return no(); }
void hlStartEffect(HLenum, HLuint) { needsContext(); }
void hlStopEffect(HLuint) { needsContext(); }
void hlUpdateEffect(HLuint) { needsContext(); }
void hlTriggerEffect(HLenum) { needsContext(); }
void hlEffectd(HLenum, HLdouble) { needsContext(); }
void hlEffecti(HLenum, HLint) { needsContext(); }
void hlEffectdv(HLenum, const HLdouble*) { needsContext(); }
void hlEffectiv(HLenum, const HLint*) { needsContext(); }
void hlGetEffectdv(HLuint, HLenum, HLdouble*) { needsContext(); }
void hlGetEffectiv(HLuint, HLenum, HLint*) { needsContext(); }
void hlGetEffectbv(HLuint, HLenum, HLboolean*) { needsContext(); }

void hlProxydv(HLenum, const HLdouble*) { needsContext(); }
void hlAddEventCallback(HLenum, HLuint, HLenum, HLeventProc, void*) { needsContext(); }
void hlRemoveEventCallback(HLenum, HLuint, HLenum, HLeventProc) { needsContext(); }
void hlCheckEvents(void) { needsContext(); }
void hlEventd(HLenum, HLdouble) { needsContext(); }

}  // extern "C"
