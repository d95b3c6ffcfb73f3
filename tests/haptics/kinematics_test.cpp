#include "haptics/kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halsted::haptics {
namespace {

const TouchJoints kInkwellJoints(0.0, 0.26889, -0.370813);       // [rad] recorded from a docked device
const Vec3 kInkwellPosition(0.0, -65.5107e-3, -88.1142e-3);      // [m]

TEST(TouchKinematics, ReproduceTheDockedStylus) {
  EXPECT_NEAR((touchPosition(kInkwellJoints) - kInkwellPosition).norm(), 0.0, 2e-7);
}

TEST(TouchKinematics, ZeroAnglesAreTheTabletopOffset) {
  EXPECT_NEAR((touchPosition(TouchJoints::Zero()) - Vec3(0.0, -0.110, -0.035)).norm(), 0.0, 1e-12);
}

TEST(TouchKinematics, InverseUndoesForwardOverTheWholeWorkspace) {
  for (double x = -0.08; x <= 0.0801; x += 0.02)
    for (double y = -0.06; y <= 0.0601; y += 0.02)
      for (double z = -0.035; z <= 0.0351; z += 0.01) {
        const Vec3 position(x, y, z);
        const auto joints = touchJoints(position);
        ASSERT_TRUE(joints.has_value()) << position.transpose();
        EXPECT_NEAR((touchPosition(*joints) - position).norm(), 0.0, 1e-12) << position.transpose();
      }
}

TEST(TouchKinematics, JacobianIsTheDerivative) {
  for (const Vec3& position : {Vec3(0.0, 0.0, 0.0), Vec3(0.05, -0.03, 0.02), Vec3(-0.07, 0.05, -0.03)}) {
    const TouchJoints joints = *touchJoints(position);
    const Mat3 jacobian = touchJacobian(joints);
    constexpr double kStep = 1e-6;  // [rad]
    for (int i = 0; i < 3; ++i) {
      const Vec3 slope = (touchPosition(joints + kStep * Vec3::Unit(i)) - touchPosition(joints - kStep * Vec3::Unit(i))) / (2 * kStep);
      EXPECT_NEAR((slope - jacobian.col(i)).norm(), 0.0, 1e-9);
    }
  }
}

TEST(TouchKinematics, PeakForceAtTheOriginNeedsThePublishedTorques) {
  // The largest torque that 3.3 N along one of the axes asks of each joint: 556, 324, 374 mN m.
  const TouchJoints joints = *touchJoints(Vec3::Zero());
  const double expected[] = {0.556, 0.324, 0.374};  // [N m]
  for (int i = 0; i < 3; ++i) {
    double largest = 0.0;  // [N m]
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(touchTorque(joints, 3.3 * Vec3::Unit(axis))[i]));
    EXPECT_NEAR(largest, expected[i], 1e-3) << i;
  }
}

TEST(TouchKinematics, TorqueAndForceDoTheSameWork) {
  const TouchJoints joints = *touchJoints(Vec3(0.03, -0.02, 0.01));
  const Vec3 force(1.0, -2.0, 0.5), turn(1e-7, -2e-7, 3e-7);  // [N] [rad]
  const Vec3 moved = touchPosition(joints + turn) - touchPosition(joints);
  EXPECT_NEAR(touchTorque(joints, force).dot(turn), force.dot(moved), 1e-12);
}

TEST(TouchKinematics, GimbalUndoesOrientation) {
  const TouchJoints joints(0.3, 0.5, -0.2);
  for (const TouchGimbal& gimbal : {TouchGimbal(0.0001, 0.797273, -1.94046), TouchGimbal(-0.8, -0.4, 0.6), TouchGimbal(1.2, 1.4, 2.5)}) {
    const Quat orientation = touchOrientation(joints, gimbal);
    EXPECT_NEAR(orientation.norm(), 1.0, 1e-12);
    EXPECT_NEAR((touchGimbal(joints, orientation) - gimbal).norm(), 0.0, 1e-9);
  }
}

TEST(TouchKinematics, TurretToTheLeftTurnsTheStylusToTheLeft) {
  // Turret left is positive and moves the tip to -x; the stylus turns with it about the vertical.
  const Quat orientation = touchOrientation(TouchJoints(0.2, 0.0, 0.0), TouchGimbal::Zero());
  EXPECT_LT(touchPosition(TouchJoints(0.2, 0.3, 0.3)).x(), 0.0);
  EXPECT_NEAR((orientation * Vec3::UnitZ() - Vec3(-std::sin(0.2), 0.0, std::cos(0.2))).norm(), 0.0, 1e-12);
}

TEST(TouchKinematics, OutOfReachHasNoAngles) {
  EXPECT_FALSE(touchJoints(Vec3(1.0, 0.0, 0.0)).has_value());
  EXPECT_FALSE(touchJoints(Vec3(0.0, std::nan(""), 0.0)).has_value());
  const TouchLinks links;
  EXPECT_FALSE(touchJoints(Vec3(0.0, links.height, -links.depth)).has_value());  // the shoulder itself
}

}  // namespace
}  // namespace halsted::haptics
