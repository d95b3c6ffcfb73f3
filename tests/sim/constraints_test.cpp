/// Laws that every constraint keeps, written once; then the closed forms of physics.md A1 (V1, V2, V3, V7).
#include <gtest/gtest.h>

#include <cmath>

#include "sim/constraints/distance.h"
#include "sim/constraints/volume.h"
#include "sim/mesh.h"

namespace halsted {
namespace {

constexpr double kStep = 1e-3;                 // [s]

/// One constraint of the kind, its particles bent out of shape, and a compliance that is soft beside h^2 w.
template <class C> struct Example;
template <> struct Example<DistanceConstraints> {
  static Particles rest() { return {{Vec3(0, 0, 0), 2.0}, {Vec3(0.7, -0.2, 0.4), 5.0}}; }
  static DistanceConstraints make(double compliance) { return makeDistanceConstraints({{0, 1}}, rest(), compliance); }
};
template <> struct Example<VolumeConstraints> {
  static Particles rest() {
    return {{Vec3(0, 0, 0), 2.0}, {Vec3(1, 0.1, 0), 5.0}, {Vec3(0.2, 0.9, 0.1), 1.0}, {Vec3(0, 0.3, 1.2), 3.0}};
  }
  static VolumeConstraints make(double compliance) { return makeVolumeConstraints({{0, 1, 2, 3}}, rest(), compliance); }
};

template <class C> Particles deformed() {
  Particles p = Example<C>::rest();
  for (std::size_t i = 0; i < p.size(); ++i) p[i].position += 0.13 * Vec3(std::sin(1.0 + 2.0 * i), std::cos(3.0 * i), std::sin(5.0 * i));
  return p;
}

template <class C> class ConstraintLaws : public testing::Test {};
using AllConstraints = testing::Types<DistanceConstraints, VolumeConstraints>;
TYPED_TEST_SUITE(ConstraintLaws, AllConstraints);

TYPED_TEST(ConstraintLaws, ZeroAtRest) {
  const TypeParam set = Example<TypeParam>::make(1e-6);
  Particles p = Example<TypeParam>::rest();
  EXPECT_DOUBLE_EQ(energy(set, p), 0.0);
  project(set, kStep, p);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_LT((p[i].position - Example<TypeParam>::rest()[i].position).norm(), 1e-15);
}

TYPED_TEST(ConstraintLaws, ForceIsMinusGradientOfEnergy) {
  const double compliance = 0.5;               // soft: alpha / h^2 is a million times the inverse masses
  const TypeParam set = Example<TypeParam>::make(compliance);
  const Particles start = deformed<TypeParam>();
  Particles moved = start;
  project(set, kStep, moved);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Vec3 force = (moved[i].position - start[i].position) / (start[i].inverseMass * kStep * kStep);   // [N]
    Vec3 gradient;                                                                                         // [N]
    for (int a = 0; a < 3; ++a) {
      Particles plus = start, minus = start;
      plus[i].position[a] += 1e-5;
      minus[i].position[a] -= 1e-5;
      gradient[a] = (energy(set, plus) - energy(set, minus)) / 2e-5;
    }
    EXPECT_LT((force + gradient).norm(), 1e-4 * gradient.norm());
    EXPECT_GT(gradient.norm(), 1e-4);
  }
}

TYPED_TEST(ConstraintLaws, ConservesLinearMomentum) {
  const TypeParam set = Example<TypeParam>::make(1e-7);
  const Particles start = deformed<TypeParam>();
  Particles p = start;
  project(set, kStep, p);
  Vec3 sum = Vec3::Zero();                     // [kg m]
  double moved = 0.0;                          // [kg m]
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum += (p[i].position - start[i].position) / p[i].inverseMass;
    moved += (p[i].position - start[i].position).norm() / p[i].inverseMass;
  }
  EXPECT_GT(moved, 1e-3);
  EXPECT_LT(sum.norm(), 1e-13 * moved);
}

TYPED_TEST(ConstraintLaws, ConservesAngularMomentum) {
  const TypeParam set = Example<TypeParam>::make(1e-7);
  const Particles start = deformed<TypeParam>();
  Particles p = start;
  project(set, kStep, p);
  Vec3 sum = Vec3::Zero();                     // [kg m^2]
  for (std::size_t i = 0; i < p.size(); ++i) sum += start[i].position.cross(p[i].position - start[i].position) / p[i].inverseMass;
  EXPECT_LT(sum.norm(), 1e-14);
}

TYPED_TEST(ConstraintLaws, InvariantUnderRotation) {
  const TypeParam set = Example<TypeParam>::make(1e-7);
  const Mat3 turn = Quat(Eigen::AngleAxisd(2.2, Vec3(1, -2, 0.5).normalized())).toRotationMatrix();
  Particles a = deformed<TypeParam>(), b = a;
  for (Particle& p : b) p.position = turn * p.position;
  EXPECT_NEAR(energy(set, a), energy(set, b), 1e-12 * energy(set, a));
  project(set, kStep, a);
  project(set, kStep, b);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((turn * a[i].position - b[i].position).norm(), 1e-14);
}

TYPED_TEST(ConstraintLaws, RepeatedSweepsWithMultipliersDoNotStiffen) {
  const TypeParam set = Example<TypeParam>::make(1e-7);
  Particles once = deformed<TypeParam>(), often = once;
  std::vector<double> multiplier(1, 0.0);      // by constraint
  for (int k = 0; k < 50; ++k) project(set, kStep, once, multiplier);
  multiplier.assign(1, 0.0);
  for (int k = 0; k < 500; ++k) project(set, kStep, often, multiplier);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_LT((once[i].position - often[i].position).norm(), 1e-12);
}

TYPED_TEST(ConstraintLaws, HeldParticlesDoNotMove) {
  const TypeParam set = Example<TypeParam>::make(0.0);
  Particles p = deformed<TypeParam>();
  for (Particle& q : p) q.inverseMass = 0.0;
  const Particles start = p;
  project(set, kStep, p);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(p[i].position, start[i].position);
}

TYPED_TEST(ConstraintLaws, FiniteWhenCollapsedToAPoint) {
  const TypeParam set = Example<TypeParam>::make(0.0);
  Particles p = Example<TypeParam>::rest();
  for (Particle& q : p) q.position = Vec3(0.3, 0.3, 0.3);
  project(set, kStep, p);
  for (const Particle& q : p) EXPECT_TRUE(q.position.allFinite());
}

TEST(ColourOrder, NeighboursInTheSweepShareNoParticleWithinAColour) {
  const TetMesh mesh = blockMesh(4, 4, 4, Vec3(1, 1, 1));
  const std::vector<int> order = colourOrder(mesh.tets);
  std::vector<char> seen(mesh.tets.size(), 0), busy(mesh.vertices.size(), 0);
  int colours = 1;
  for (int t : order) {
    EXPECT_FALSE(seen[t]);
    seen[t] = 1;
    const auto touches = [&] { return busy[mesh.tets[t][0]] + busy[mesh.tets[t][1]] + busy[mesh.tets[t][2]] + busy[mesh.tets[t][3]]; };
    if (touches()) {
      busy.assign(busy.size(), 0);
      ++colours;
    }
    for (int v : mesh.tets[t]) busy[v] = 1;
  }
  EXPECT_EQ(order.size(), mesh.tets.size());
  EXPECT_LE(colours, 60);
}

// ---- closed forms ----------------------------------------------------------------------------------------------------------------

/// A mass on a spring under gravity; symplectic Euler, then `iterations` sweeps. The scheme under test, in full.
struct Spring {
  double mass = 0.02, compliance = 1e-3, gravity = 9.81, damping = 0.0;   // [kg], [m/N], [m/s^2], [1/s]
  Particles p{{Vec3::Zero(), 0.0}, {Vec3(0, -0.1, 0), 50.0}};
  DistanceConstraints set = makeDistanceConstraints({{0, 1}}, p, 1e-3);
  Vec3 velocity = Vec3::Zero();                                           // [m/s]

  void substep(double h, int iterations, bool keepMultiplier) {           // h [s]
    velocity = velocity / (1.0 + h * damping) - Vec3(0, h * gravity, 0);
    const Vec3 before = p[1].position;
    p[1].position += h * velocity;
    std::vector<double> multiplier(1, 0.0);
    for (int k = 0; k < iterations; ++k) keepMultiplier ? project(set, h, p, multiplier) : project(set, h, p);
    velocity = (p[1].position - before) / h;
  }
  double stretch() const { return -p[1].position.y() - 0.1; }             // [m]
};

double settledStretch(int substeps, int iterations, bool keepMultiplier) {
  Spring spring;
  spring.damping = 200.0;                      // near critical for w = 224 rad/s
  for (int k = 0; k < 1000 * substeps; ++k) spring.substep(1e-3 / substeps, iterations, keepMultiplier);
  return spring.stretch();
}

TEST(DistanceConstraints, FreeFallIsSymplecticEulerExactly) {             // V1
  Spring fall;
  fall.set = {};
  const double h = 1e-3;
  for (int n = 1; n <= 1000; ++n) {
    fall.substep(h, 1, false);
    const double exact = -0.1 - fall.gravity * h * h * n * (n + 1) / 2.0;
    ASSERT_NEAR(fall.p[1].position.y(), exact, 1e-11 * std::fabs(exact));   // velocity comes from rounded positions
  }
}

TEST(DistanceConstraints, StaticStretchIsLoadTimesCompliance) {           // V2
  const double exact = 0.02 * 9.81 * 1e-3;     // [m] m g alpha
  for (int substeps : {1, 8, 32})
    for (int iterations : {1, 3, 10, 30}) EXPECT_NEAR(settledStretch(substeps, iterations, true), exact, 1e-6 * exact);
}

TEST(DistanceConstraints, WithoutMultipliersIterationsStiffenAsInPlainPbd) {   // V2, the failure that multipliers cure
  const double exact = 0.02 * 9.81 * 1e-3;     // [m]
  EXPECT_LT(settledStretch(1, 30, false), 0.2 * exact);
}

TEST(DistanceConstraints, OscillatorLosesTheAmplitudeOfImplicitEuler) {   // V3
  Spring spring;
  spring.gravity = 0.0;
  spring.p[1].position.y() -= 1e-3;
  const double h = 2e-4, w2 = 1.0 / (spring.mass * spring.compliance);    // [s], [1/s^2]
  double before = 1e-3 * 1e-3;                 // [m^2] |x|^2 + |v/w|^2
  for (int k = 0; k < 200; ++k) {
    spring.substep(h, 1, false);
    const double now = spring.stretch() * spring.stretch() + spring.velocity.squaredNorm() / w2;
    ASSERT_NEAR(std::sqrt(now / before), 1.0 / std::sqrt(1.0 + w2 * h * h), 1e-9);
    before = now;
  }
}

double periodError(double h) {                 // h [s] -> [1]
  Spring spring;
  spring.gravity = 0.0;
  spring.p[1].position.y() -= 1e-3;
  const double w = 1.0 / std::sqrt(spring.mass * spring.compliance);      // [rad/s]
  double last = spring.stretch(), time = 0.0, first = -1.0, crossing = 0.0;
  int count = 0;
  while (count < 7) {                          // down-crossings of zero are a period apart whatever the damping
    spring.substep(h, 1, false);
    time += h;
    if (last > 0.0 && spring.stretch() <= 0.0) {
      crossing = time - h * spring.stretch() / (spring.stretch() - last);
      if (first < 0.0) first = crossing;
      ++count;
    }
    last = spring.stretch();
  }
  return std::fabs((crossing - first) / 6.0 * w / (2.0 * 3.14159265358979312) - 1.0);
}

TEST(DistanceConstraints, OscillatorPeriodErrorFallsWithTheSquareOfTheStep) {   // V3
  EXPECT_NEAR(periodError(2e-4) / periodError(1e-4), 4.0, 0.2);
}

Particles unitTet(double scale) {              // [1]
  Particles p = Example<VolumeConstraints>::rest();
  for (Particle& q : p) q.position *= scale;
  return p;
}

double signedVolume(const Particles& p) {      // [m^3]
  return (p[1].position - p[0].position).cross(p[2].position - p[0].position).dot(p[3].position - p[0].position) / 6.0;
}

TEST(VolumeConstraints, AScaledTetReturnsToItsVolume) {                   // V7
  const VolumeConstraints set = Example<VolumeConstraints>::make(0.0);
  for (double scale : {0.3, 0.7, 1.5, 3.0}) {
    Particles p = unitTet(scale);
    for (int k = 0; k < 40; ++k) project(set, kStep, p);
    EXPECT_NEAR(signedVolume(p) / set.restVolume[0], 1.0, 1e-9) << scale;
  }
}

TEST(VolumeConstraints, AFlatTetRecovers) {                               // V7
  const VolumeConstraints set = Example<VolumeConstraints>::make(0.0);
  Particles p = unitTet(1.0);
  for (Particle& q : p) q.position.z() = 0.0;
  for (int k = 0; k < 60; ++k) project(set, kStep, p);
  EXPECT_NEAR(signedVolume(p) / set.restVolume[0], 1.0, 1e-9);
}

TEST(VolumeConstraints, AnInvertedTetRecoversItsSign) {                   // V7
  const VolumeConstraints set = Example<VolumeConstraints>::make(0.0);
  Particles p = unitTet(1.0);
  for (Particle& q : p) q.position.z() *= -1.0;
  ASSERT_LT(signedVolume(p), 0.0);
  for (int k = 0; k < 200; ++k) project(set, kStep, p);
  EXPECT_NEAR(signedVolume(p) / set.restVolume[0], 1.0, 1e-9);
}

}  // namespace
}  // namespace halsted
