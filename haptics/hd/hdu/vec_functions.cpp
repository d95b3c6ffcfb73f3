/// Vectors of three doubles for C programs. No C++ library in it: programs link libHDU.a with a C compiler.
#include <HDU/hduVecFunctions.h>
#include <math.h>

extern "C" {

void hduVecSet(HDdouble* vec, HDdouble x, HDdouble y, HDdouble z) {
  vec[0] = x;
  vec[1] = y;
  vec[2] = z;
}

HDdouble hduVecDotProduct(const HDdouble* vec1, const HDdouble* vec2) {
  return vec1[0] * vec2[0] + vec1[1] * vec2[1] + vec1[2] * vec2[2];
}

HDdouble hduVecMagnitude(const HDdouble* vec) { return sqrt(hduVecDotProduct(vec, vec)); }

HDboolean hduVecIsZero(const HDdouble* vec, HDdouble epsilon) {
  return fabs(vec[0]) <= epsilon && fabs(vec[1]) <= epsilon && fabs(vec[2]) <= epsilon;
}

void hduVecAdd(HDdouble* res, const HDdouble* vec1, const HDdouble* vec2) {
  hduVecSet(res, vec1[0] + vec2[0], vec1[1] + vec2[1], vec1[2] + vec2[2]);
}

void hduVecSubtract(HDdouble* res, const HDdouble* vec1, const HDdouble* vec2) {
  hduVecSet(res, vec1[0] - vec2[0], vec1[1] - vec2[1], vec1[2] - vec2[2]);
}

void hduVecScale(HDdouble* res, const HDdouble* vec, HDdouble s) { hduVecSet(res, vec[0] * s, vec[1] * s, vec[2] * s); }
void hduVecScaleInPlace(HDdouble* vec, HDdouble s) { hduVecScale(vec, vec, s); }

void hduVecScaleNonUniform(HDdouble* res, const HDdouble* vec, const HDdouble* s) {
  hduVecSet(res, vec[0] * s[0], vec[1] * s[1], vec[2] * s[2]);
}

void hduVecScaleNonUniformInPlace(HDdouble* vec, const HDdouble* s) { hduVecScaleNonUniform(vec, vec, s); }

void hduVecNormalize(HDdouble* res, const HDdouble* vec) {
  const HDdouble length = hduVecMagnitude(vec);
  hduVecScale(res, vec, length > 0.0 ? 1.0 / length : 1.0);
}

void hduVecNormalizeInPlace(HDdouble* vec) { hduVecNormalize(vec, vec); }

void hduVecCrossProduct(HDdouble* res, const HDdouble* vec1, const HDdouble* vec2) {
  hduVecSet(res, vec1[1] * vec2[2] - vec1[2] * vec2[1], vec1[2] * vec2[0] - vec1[0] * vec2[2], vec1[0] * vec2[1] - vec1[1] * vec2[0]);
}

HDdouble hduVecDistance(const HDdouble* vec1, const HDdouble* vec2) {
  HDdouble difference[3];
  hduVecSubtract(difference, vec1, vec2);
  return hduVecMagnitude(difference);
}

}  // extern "C"
