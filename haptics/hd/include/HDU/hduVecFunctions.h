/* Functions on three doubles, for C and C++. */
#ifndef HALSTED_HDU_VEC_FUNCTIONS_H
#define HALSTED_HDU_VEC_FUNCTIONS_H

#include <HD/hdDefines.h>

#ifdef __cplusplus
extern "C" {
#endif

void hduVecSet(HDdouble *vec, HDdouble x, HDdouble y, HDdouble z);
HDdouble hduVecMagnitude(const HDdouble *vec);
HDboolean hduVecIsZero(const HDdouble *vec, HDdouble epsilon);
void hduVecAdd(HDdouble *res, const HDdouble *vec1, const HDdouble *vec2);
void hduVecSubtract(HDdouble *res, const HDdouble *vec1, const HDdouble *vec2);
void hduVecScale(HDdouble *res, const HDdouble *vec, HDdouble s);
void hduVecScaleInPlace(HDdouble *vec, HDdouble s);
void hduVecScaleNonUniform(HDdouble *res, const HDdouble *vec, const HDdouble *s);
void hduVecScaleNonUniformInPlace(HDdouble *vec, const HDdouble *s);
void hduVecNormalize(HDdouble *res, const HDdouble *vec);
void hduVecNormalizeInPlace(HDdouble *vec);
void hduVecCrossProduct(HDdouble *res, const HDdouble *vec1, const HDdouble *vec2);
HDdouble hduVecDotProduct(const HDdouble *vec1, const HDdouble *vec2);
HDdouble hduVecDistance(const HDdouble *vec1, const HDdouble *vec2);

#ifdef __cplusplus
}
#endif

#endif
