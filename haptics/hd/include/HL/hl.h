/* The HL API as far as programs need it to compile and to link. This library renders no shapes and no effects by itself: there is no
   context to be had. hlCreateContext gives NULL and HL_DEVICE_ERROR; every other call gives HL_INVALID_OPERATION, as calls without a
   context do, writes nothing and does nothing. HD does all that it says. */
#ifndef HALSTED_HL_H
#define HALSTED_HL_H

#include <HL/hlDefines.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Contexts and frames */
HLAPI HHLRC HLAPIENTRY hlCreateContext(HHD hHD);
HLAPI void HLAPIENTRY hlDeleteContext(HHLRC hHLRC);
HLAPI void HLAPIENTRY hlMakeCurrent(HHLRC hHLRC);
HLAPI void HLAPIENTRY hlContextDevice(HHD hHD);
HLAPI HHLRC HLAPIENTRY hlGetCurrentContext(void);
HLAPI HHD HLAPIENTRY hlGetCurrentDevice(void);
HLAPI void HLAPIENTRY hlBeginFrame(void);
HLAPI void HLAPIENTRY hlEndFrame(void);

/* Errors: the last one first; HL_NO_ERROR when there is none. */
HLAPI HLerror HLAPIENTRY hlGetError(void);

/* State */
HLAPI void HLAPIENTRY hlEnable(HLenum cap);
HLAPI void HLAPIENTRY hlDisable(HLenum cap);
HLAPI HLboolean HLAPIENTRY hlIsEnabled(HLenum cap);
HLAPI void HLAPIENTRY hlGetBooleanv(HLenum pname, HLboolean *params);
HLAPI void HLAPIENTRY hlGetDoublev(HLenum pname, HLdouble *params);
HLAPI void HLAPIENTRY hlGetIntegerv(HLenum pname, HLint *params);
HLAPI const HLubyte *HLAPIENTRY hlGetString(HLenum name);
HLAPI void HLAPIENTRY hlHinti(HLenum target, HLint value);
HLAPI void HLAPIENTRY hlHintb(HLenum target, HLboolean value);
HLAPI void HLAPIENTRY hlPushAttrib(HLbitfield mask);
HLAPI void HLAPIENTRY hlPopAttrib(void);
HLAPI HLboolean HLAPIENTRY hlDeploymentLicense(const char *vendorName, const char *applicationName, const char *password);
HLAPI void HLAPIENTRY hlCacheGetBooleanv(HLcache *cache, HLenum pname, HLboolean *params);
HLAPI void HLAPIENTRY hlCacheGetDoublev(HLcache *cache, HLenum pname, HLdouble *params);

/* Shapes and their surfaces */
HLAPI HLuint HLAPIENTRY hlGenShapes(HLsizei range);
HLAPI void HLAPIENTRY hlDeleteShapes(HLuint shape, HLsizei range);
HLAPI HLboolean HLAPIENTRY hlIsShape(HLuint shape);
HLAPI void HLAPIENTRY hlBeginShape(HLenum type, HLuint shape);
HLAPI void HLAPIENTRY hlEndShape(void);
HLAPI void HLAPIENTRY hlGetShapeBooleanv(HLuint shape, HLenum pname, HLboolean *params);
HLAPI void HLAPIENTRY hlGetShapeDoublev(HLuint shape, HLenum pname, HLdouble *params);
HLAPI void HLAPIENTRY hlLocalFeature1fv(HLgeom *geom, HLenum type, const HLfloat *v);
HLAPI void HLAPIENTRY hlLocalFeature1dv(HLgeom *geom, HLenum type, const HLdouble *v);
HLAPI void HLAPIENTRY hlLocalFeature2fv(HLgeom *geom, HLenum type, const HLfloat *v1, const HLfloat *v2);
HLAPI void HLAPIENTRY hlLocalFeature2dv(HLgeom *geom, HLenum type, const HLdouble *v1, const HLdouble *v2);
HLAPI void HLAPIENTRY hlMaterialf(HLenum face, HLenum pname, HLfloat param);
HLAPI void HLAPIENTRY hlGetMaterialfv(HLenum face, HLenum pname, HLfloat *params);
HLAPI void HLAPIENTRY hlTouchableFace(HLenum mode);
HLAPI void HLAPIENTRY hlTouchModel(HLenum mode);
HLAPI void HLAPIENTRY hlTouchModelf(HLenum pname, HLfloat param);
HLAPI void HLAPIENTRY hlCallback(HLenum type, HLcallbackProc fn, void *userdata);

/* Effects */
HLAPI HLuint HLAPIENTRY hlGenEffects(HLsizei range);
HLAPI void HLAPIENTRY hlDeleteEffects(HLuint effect, HLsizei range);
HLAPI HLboolean HLAPIENTRY hlIsEffect(HLuint effect);
HLAPI void HLAPIENTRY hlStartEffect(HLenum type, HLuint effect);
HLAPI void HLAPIENTRY hlStopEffect(HLuint effect);
HLAPI void HLAPIENTRY hlUpdateEffect(HLuint effect);
HLAPI void HLAPIENTRY hlTriggerEffect(HLenum type);
HLAPI void HLAPIENTRY hlEffectd(HLenum pname, HLdouble param);
HLAPI void HLAPIENTRY hlEffecti(HLenum pname, HLint param);
HLAPI void HLAPIENTRY hlEffectdv(HLenum pname, const HLdouble *params);
HLAPI void HLAPIENTRY hlEffectiv(HLenum pname, const HLint *params);
HLAPI void HLAPIENTRY hlGetEffectdv(HLuint effect, HLenum pname, HLdouble *params);
HLAPI void HLAPIENTRY hlGetEffectiv(HLuint effect, HLenum pname, HLint *params);
HLAPI void HLAPIENTRY hlGetEffectbv(HLuint effect, HLenum pname, HLboolean *params);

/* The proxy and the events */
HLAPI void HLAPIENTRY hlProxydv(HLenum pname, const HLdouble *params);
HLAPI void HLAPIENTRY hlAddEventCallback(HLenum event, HLuint shape, HLenum thread, HLeventProc fn, void *userdata);
HLAPI void HLAPIENTRY hlRemoveEventCallback(HLenum event, HLuint shape, HLenum thread, HLeventProc fn);
HLAPI void HLAPIENTRY hlCheckEvents(void);
HLAPI void HLAPIENTRY hlEventd(HLenum pname, HLdouble param);

/* Transforms */
HLAPI void HLAPIENTRY hlMatrixMode(HLenum mode);
HLAPI void HLAPIENTRY hlLoadIdentity(void);
HLAPI void HLAPIENTRY hlLoadMatrixd(const HLdouble *m);
HLAPI void HLAPIENTRY hlLoadMatrixf(const HLfloat *m);
HLAPI void HLAPIENTRY hlMultMatrixd(const HLdouble *m);
HLAPI void HLAPIENTRY hlMultMatrixf(const HLfloat *m);
HLAPI void HLAPIENTRY hlPushMatrix(void);
HLAPI void HLAPIENTRY hlPopMatrix(void);
HLAPI void HLAPIENTRY hlRotated(HLdouble angle, HLdouble x, HLdouble y, HLdouble z);
HLAPI void HLAPIENTRY hlRotatef(HLfloat angle, HLfloat x, HLfloat y, HLfloat z);
HLAPI void HLAPIENTRY hlScaled(HLdouble x, HLdouble y, HLdouble z);
HLAPI void HLAPIENTRY hlScalef(HLfloat x, HLfloat y, HLfloat z);
HLAPI void HLAPIENTRY hlTranslated(HLdouble x, HLdouble y, HLdouble z);
HLAPI void HLAPIENTRY hlTranslatef(HLfloat x, HLfloat y, HLfloat z);
HLAPI void HLAPIENTRY hlOrtho(HLdouble left, HLdouble right, HLdouble bottom, HLdouble top, HLdouble zNear, HLdouble zFar);
HLAPI void HLAPIENTRY hlFrustum(HLdouble left, HLdouble right, HLdouble bottom, HLdouble top, HLdouble zNear, HLdouble zFar);
HLAPI void HLAPIENTRY hlWorkspace(HLdouble left, HLdouble bottom, HLdouble back, HLdouble right, HLdouble top, HLdouble front);

#ifdef __cplusplus
}
#endif

#endif
