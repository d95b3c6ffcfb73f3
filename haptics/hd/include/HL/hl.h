/* The basic types of the HL API and no function of it: many programs include this header and use only HD. */
#ifndef HALSTED_HL_H
#define HALSTED_HL_H

#include <HD/hd.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef unsigned int HLenum;
typedef unsigned char HLboolean;
typedef int HLint;
typedef unsigned int HLuint;
typedef float HLfloat;
typedef double HLdouble;
typedef long HLlong;
typedef unsigned long HLulong;
typedef char HLchar;
typedef const char *HLstring;
typedef void HLvoid;
typedef void *HHLRC;

typedef struct {
  HLenum errorCode;
  HDErrorInfo errorInfo;
} HLerror;

#ifdef __cplusplus
}
#endif

#define HL_TRUE 1
#define HL_FALSE 0

#ifndef HLCALLBACK
#define HLCALLBACK
#endif
#ifndef HLAPIENTRY
#define HLAPIENTRY
#endif

#endif
