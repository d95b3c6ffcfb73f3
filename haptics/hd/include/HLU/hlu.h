/* Helpers of the HL API. They work on an HL context, and there is none to be had (HL/hl.h): each raises HL_INVALID_OPERATION and does
   nothing; one that returns a number returns 0. For a program of HD alone, HDU/hdu.h has what maps the workspace. */
#ifndef HALSTED_HLU_H
#define HALSTED_HLU_H

#include <HL/hl.h>

#ifdef __cplusplus
extern "C" {
#endif

void hluFitWorkspace(const HLdouble *projMatrix);
void hluFitWorkspaceNonUniform(const HLdouble *projMatrix);
void hluFitWorkspaceBox(const HLdouble *modelMatrix, const HLdouble *minPoint, const HLdouble *maxPoint);
void hluFitWorkspaceBoxNonUniform(const HLdouble *modelMatrix, const HLdouble *minPoint, const HLdouble *maxPoint);
HLdouble hluScreenToModelScale(const HLdouble *modelMatrix, const HLdouble *projMatrix, const HLint *viewport);
void hluModelToWorldTransform(const HLdouble *modelMatrix, HLdouble *worldMatrix);

#ifdef __cplusplus
}
#endif

#endif
