#pragma once
/// Derivatives that the materials share.
#include "sim/types.h"

namespace halsted {

/// Gradient of det F with respect to F: the cofactor matrix, defined for singular F too.  F [1]
inline Mat3 cofactor(const Mat3& F) {
  Mat3 c;
  c.col(0) = F.col(1).cross(F.col(2));
  c.col(1) = F.col(2).cross(F.col(0));
  c.col(2) = F.col(0).cross(F.col(1));
  return c;
}

/// Change of the cofactor matrix when F changes by dF.  F, dF [1]
inline Mat3 cofactorDifferential(const Mat3& F, const Mat3& dF) {
  Mat3 c;
  c.col(0) = dF.col(1).cross(F.col(2)) + F.col(1).cross(dF.col(2));
  c.col(1) = dF.col(2).cross(F.col(0)) + F.col(2).cross(dF.col(0));
  c.col(2) = dF.col(0).cross(F.col(1)) + F.col(0).cross(dF.col(1));
  return c;
}

/// A : B
inline double contract(const Mat3& A, const Mat3& B) { return A.cwiseProduct(B).sum(); }   // A, B any unit

}  // namespace halsted
