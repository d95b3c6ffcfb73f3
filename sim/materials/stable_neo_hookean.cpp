#include "sim/materials/stable_neo_hookean.h"

#include "sim/materials/matrix_calculus.h"

namespace halsted {
namespace {

double volumetric(const StableNeoHookean& m) { return m.lambda + m.mu; }   // [Pa]

}  // namespace

double energyDensity(const StableNeoHookean& m, const Mat3& F) {
  const double l = volumetric(m);                                       // [Pa]
  const double excess = F.determinant() - 1.0 - m.mu / l;               // [1]
  return 0.5 * m.mu * (F.squaredNorm() - 3.0) + 0.5 * l * excess * excess - 0.5 * m.mu * m.mu / l;
}

Mat3 stress(const StableNeoHookean& m, const Mat3& F) {
  const double l = volumetric(m);                                       // [Pa]
  return m.mu * F + (l * (F.determinant() - 1.0) - m.mu) * cofactor(F);
}

Mat3 stressDifferential(const StableNeoHookean& m, const Mat3& F, const Mat3& dF) {
  const double l = volumetric(m);                                       // [Pa]
  const Mat3 c = cofactor(F);
  return m.mu * dF + l * contract(c, dF) * c + (l * (F.determinant() - 1.0) - m.mu) * cofactorDifferential(F, dF);
}

}  // namespace halsted
