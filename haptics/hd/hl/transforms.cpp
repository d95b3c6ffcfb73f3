/// HL: transforms. They belong to a context.
#include "haptics/hd/hl/errors.h"

namespace {
void needsContext() { halsted::haptics::hl::raise(HL_INVALID_OPERATION); }
}  // namespace

extern "C" {

void hlMatrixMode(HLenum) { needsContext(); }
void hlLoadIdentity(void) { needsContext(); }
void hlLoadMatrixd(const HLdouble*) { needsContext(); }
void hlLoadMatrixf(const HLfloat*) { needsContext(); }
void hlMultMatrixd(const HLdouble*) { needsContext(); }
void hlMultMatrixf(const HLfloat*) { needsContext(); }
void hlPushMatrix(void) { needsContext(); }
void hlPopMatrix(void) { needsContext(); }
void hlRotated(HLdouble, HLdouble, HLdouble, HLdouble) { needsContext(); }
void hlRotatef(HLfloat, HLfloat, HLfloat, HLfloat) { needsContext(); }
void hlScaled(HLdouble, HLdouble, HLdouble) { needsContext(); }
void hlScalef(HLfloat, HLfloat, HLfloat) { needsContext(); }
void hlTranslated(HLdouble, HLdouble, HLdouble) { needsContext(); }
void hlTranslatef(HLfloat, HLfloat, HLfloat) { needsContext(); }
void hlOrtho(HLdouble, HLdouble, HLdouble, HLdouble, HLdouble, HLdouble) { needsContext(); }
void hlFrustum(HLdouble, HLdouble, HLdouble, HLdouble, HLdouble, HLdouble) { needsContext(); }
void hlWorkspace(HLdouble, HLdouble, HLdouble, HLdouble, HLdouble, HLdouble) { needsContext(); }

}  // extern "C"
