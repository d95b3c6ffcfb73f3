/* Types and names of the HL API. A name is a text of the library, so that it can be compared and printed: HLenum is a pointer. */
#ifndef HALSTED_HL_DEFINES_H
#define HALSTED_HL_DEFINES_H

#include <HD/hd.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef const char *HLenum;
typedef unsigned char HLboolean;
typedef unsigned char HLubyte;
typedef int HLint;
typedef unsigned int HLuint;
typedef int HLsizei;
typedef unsigned int HLbitfield;
typedef float HLfloat;
typedef double HLdouble;
typedef long HLlong;
typedef unsigned long HLulong;
typedef unsigned long long HLtime;
typedef char HLchar;
typedef const char *HLstring;
typedef void HLvoid;
typedef void *HHLRC;

typedef struct HLcache_tag HLcache;
typedef struct HLgeom_tag HLgeom;

typedef struct {
  HLenum errorCode;
  HDErrorInfo errorInfo; /* the device's, with HL_DEVICE_ERROR */
} HLerror;

#ifndef HLCALLBACK
#define HLCALLBACK
#endif
#ifndef HLAPIENTRY
#define HLAPIENTRY
#endif
#if defined(HALSTED_HL_BUILD) && defined(__GNUC__)
#define HLAPI __attribute__((visibility("default")))
#else
#define HLAPI
#endif

typedef void(HLCALLBACK *HLcallbackProc)(void);
typedef void(HLCALLBACK *HLeventProc)(HLenum event, HLuint object, HLenum thread, HLcache *cache, void *userdata);
typedef HLboolean(HLCALLBACK *HLintersectLSProc)(const HLdouble startPt[3], const HLdouble endPt[3], HLdouble intersectionPt[3],
                                                 HLdouble intersectionNormal[3], HLenum *face, void *userdata);
typedef HLboolean(HLCALLBACK *HLclosestFeaturesProc)(const HLdouble queryPt[3], const HLdouble targetPt[3], HLgeom *geom,
                                                     HLdouble closestPt[3], void *userdata);
typedef void(HLCALLBACK *HLeffectStartProc)(HLcache *cache, void *userdata);
typedef void(HLCALLBACK *HLeffectStopProc)(HLcache *cache, void *userdata);
typedef void(HLCALLBACK *HLcomputeForceProc)(HDdouble force[3], HLcache *cache, void *userdata);

#define HL_TRUE 1
#define HL_FALSE 0
#define HL_VERSION_MAJOR_NUMBER 3
#define HL_VERSION_MINOR_NUMBER 30
#define HL_VERSION_BUILD_NUMBER 0
#define HL_ERROR(X) ((X).errorCode != HL_NO_ERROR)

/* Groups of hlPushAttrib. */
#define HL_HINT_BIT 0x01
#define HL_MATERIAL_BIT 0x02
#define HL_TOUCH_BIT 0x04
#define HL_TRANSFORM_BIT 0x08
#define HL_EFFECT_BIT 0x10
#define HL_EVENTS_BIT 0x20
#define HL_OBJECT_ANY 0u

#define HALSTED_HL_NAME(NAME) HLAPI extern const HLenum NAME;
#include <HL/hlNames.h>
#undef HALSTED_HL_NAME

#ifdef __cplusplus
}
#endif

#endif
