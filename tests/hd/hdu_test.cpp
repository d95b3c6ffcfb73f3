/// The HDU classes: vectors, matrices for row vectors, quaternions, planes, the mapping of the workspace.
#include <HDU/hdu.h>
#include <HDU/hduBoundBox.h>
#include <HDU/hduError.h>
#include <HDU/hduMath.h>
#include <HDU/hduMatrix.h>
#include <HDU/hduPlane.h>
#include <HDU/hduQuaternion.h>
#include <HDU/hduRecord.h>

#include <cmath>
#include <sstream>

#include "tests/hd/hd_rig.h"

namespace halsted::hdtest {
namespace {

constexpr double kHalfPi = 1.5707963267948966;

void expectNear(const hduVector3Dd& a, const hduVector3Dd& b, double within = 1e-12) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], within);
}

TEST(HduVector, CalculatesLikeAVector) {
  const hduVector3Dd a(1, 2, 3), b(4, -5, 6);
  expectNear(a + b, {5, -3, 9});
  expectNear(2 * a - b / 2.0f, {0, 6.5, 3});
  EXPECT_EQ(a.dotProduct(b), dotProduct(b, a));
  expectNear(crossProduct(a, b), {27, 6, -13});
  EXPECT_DOUBLE_EQ(hduVector3Dd(3, 4, 0).magnitude(), 5.0);
  EXPECT_DOUBLE_EQ(normalize(b).magnitude(), 1.0);
  expectNear(hduVector3Dd(0, 0, 0).normalize(), {0, 0, 0});
  EXPECT_EQ(b.getLongestAxisComponent(), 2);
  EXPECT_EQ(b.getSecondLongestAxisComponent(), 1);
  EXPECT_EQ(b.getShortestAxisComponent(), 0);
  const long index = 1;
  const std::size_t size = 2;
  EXPECT_EQ(a[index] + a[size], 5.0);
  EXPECT_TRUE(hduVector3Df(a) == hduVector3Df(1, 2, 3));
  EXPECT_TRUE(a != b);
  std::ostringstream text;
  text << a;
  EXPECT_EQ(text.str(), "1 2 3");
}

TEST(HduVector, HasFunctionsForThreeDoubles) {
  double sum[3], unit[3];
  const double a[3] = {1, 2, 2}, b[3] = {0, 1, 0};
  hduVecAdd(sum, a, b);
  EXPECT_EQ(sum[1], 3.0);
  EXPECT_EQ(hduVecMagnitude(a), 3.0);
  hduVecNormalize(unit, a);
  EXPECT_NEAR(hduVecDotProduct(unit, unit), 1.0, 1e-15);
  hduVecCrossProduct(sum, a, b);
  EXPECT_EQ(hduVecDotProduct(sum, a), 0.0);
  hduVecScaleInPlace(unit, 0.0);
  EXPECT_TRUE(hduVecIsZero(unit, 0.0));
}

TEST(HduMatrix, TakesATransformAsItComes) {
  HDdouble transform[16] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1};  // column-major: 90 degrees about z, then a shift
  const hduMatrix matrix(transform);
  expectNear(hduVector3Dd(0, 0, 0) * matrix, {10, 20, 30});
  expectNear(hduVector3Dd(1, 0, 0) * matrix, {10, 21, 30});
  hduVector3Dd direction;
  matrix.multDirMatrix({1, 0, 0}, direction);
  expectNear(direction, {0, 1, 0});
  EXPECT_EQ(matrix[3][0], 10.0);
  EXPECT_EQ(matrix(3, 1), 20.0);
  EXPECT_EQ(static_cast<const double*>(matrix)[14], 30.0);
}

TEST(HduMatrix, RotatesRightHandedAndMultipliesInOrder) {
  expectNear(hduVector3Dd(1, 0, 0) * hduMatrix::createRotationAroundZ(kHalfPi), {0, 1, 0});
  expectNear(hduVector3Dd(0, 1, 0) * hduMatrix::createRotation(1, 0, 0, kHalfPi), {0, 0, 1});
  const hduMatrix turn = hduMatrix::createRotationAroundZ(kHalfPi), move = hduMatrix::createTranslation(5, 0, 0);
  expectNear(hduVector3Dd(1, 0, 0) * (turn * move), {5, 1, 0});   // first the left one
  hduMatrix both = turn;
  both.multRight(move);
  EXPECT_TRUE(both == turn * move);
  both = turn;
  both.multLeft(move);
  expectNear(hduVector3Dd(1, 0, 0) * both, {0, 6, 0});
}

TEST(HduMatrix, InvertsAndFindsItsRotation) {
  const hduMatrix turn = hduMatrix::createRotation(hduVector3Dd(1, 2, 3), 0.7);
  const hduMatrix m = hduMatrix::createScale(2, 3, 4) * turn * hduMatrix::createTranslation(7, 8, 9);
  EXPECT_TRUE((m * m.getInverse()).isIdentity(1e-12));
  EXPECT_NEAR(m.determinant(), 24.0, 1e-9);
  hduMatrix rotation;
  (hduMatrix::createScale(2, 2, 2) * turn * hduMatrix::createTranslation(7, 8, 9)).getRotationMatrix(rotation);
  EXPECT_TRUE(rotation.compare(turn, 1e-12));
  hduMatrix flat = hduMatrix::createScale(1, 0, 1);
  EXPECT_FALSE(flat.invert());
  EXPECT_TRUE((turn * turn.getTranspose()).isIdentity(1e-12));
}

TEST(HduQuaternion, TurnsAsItsMatrixDoes) {
  for (int i = 0; i < 200; ++i) {
    const hduVector3Dd axis = normalize(hduVector3Dd(std::sin(i), std::cos(3.0 * i), std::sin(7.0 * i + 1)));
    const double angle = 0.0157 * i;
    const hduMatrix matrix = hduMatrix::createRotation(axis, angle);
    const hduQuaternion q(matrix);
    hduVector3Dd found;
    double turned = 0.0;
    q.toAxisAngle(found, turned);
    EXPECT_NEAR(std::fabs(hduQuaternion(axis, angle).s()), std::fabs(q.s()), 1e-9);
    if (angle > 0.01 && angle < 3.1) expectNear(found * turned, axis * angle, 1e-7);
    hduMatrix back;
    q.toRotationMatrix(back);
    EXPECT_TRUE(back.compare(matrix, 1e-9)) << i;
  }
  const hduQuaternion a(hduVector3Dd(0, 0, 1), 0.2), b(hduVector3Dd(0, 0, 1), 1.0);
  EXPECT_NEAR((a.inverse() * a).s(), 1.0, 1e-15);
  EXPECT_NEAR(hduSlerp(a, b, 0.5).s(), std::cos(0.3), 1e-12);
  EXPECT_NEAR((a * b).s(), std::cos(0.6), 1e-12);
}

TEST(HduGeometry, HasPlanesLinesAndBoxes) {
  const hduPlaned plane(hduVector3Dd(0, 2, 0), hduVector3Dd(5, 3, 5));
  EXPECT_DOUBLE_EQ(plane.perpDistance({0, 10, 0}), 7.0);
  expectNear(plane.projectPoint({1, 10, 2}), {1, 3, 2});
  hduVector3Dd hit;
  EXPECT_TRUE(plane.intersectSegment({{0, 0, 0}, {0, 6, 0}}, hit));
  expectNear(hit, {0, 3, 0});
  EXPECT_FALSE(plane.intersectSegment({{0, 4, 0}, {0, 6, 0}}, hit));
  EXPECT_DOUBLE_EQ(hduLineSegmentd({0, 0, 0}, {1, 0, 0}).distance({3, 0, 0}), 2.0);
  hduBoundBox3Dd box;
  EXPECT_TRUE(box.isEmpty());
  box.Union({1, 2, 3});
  box.Union({-1, 5, 0});
  expectNear(box.lo(), {-1, 2, 0});
  expectNear(box.hi(), {1, 5, 3});
  box.rHi()[0] = 4;
  EXPECT_TRUE(box.contains({3, 3, 1}));
  EXPECT_EQ(hduClamp(5.0, 0.0, 1.0), 1.0);
  EXPECT_EQ(hduRound(-2.5), -3);
  EXPECT_EQ(hduLerp(2.0, 4.0, 0.25), 2.5);
}

TEST(HduGeometry, TellsFromWhichSideAPlaneIsMet) {
  const hduPlaned plane(hduVector3Dd(0, 2, 0), -6.0);                // y = 3, whatever the length of the normal
  EXPECT_EQ(plane.b(), 1.0);
  EXPECT_EQ(plane.d(), -3.0);
  const hduLineSegmentd down({0, 6, 0}, {0, 0, 0}), up({0, 0, 0}, {0, 4, 0}), away({0, 6, 0}, {0, 4, 0}), along({0, 3, 0}, {1, 3, 0});
  double t = -1.0;
  EXPECT_EQ(plane.intersectSegmentFront(down, t, 1e-9), hduPlaned::ResultFront);
  EXPECT_DOUBLE_EQ(t, 0.5);
  EXPECT_EQ(plane.intersectSegmentBack(down, t, 1e-9), hduPlaned::ResultNone);
  EXPECT_EQ(plane.intersectSegmentFrontAndBack(up, t, 1e-9), hduPlaned::ResultBack);
  EXPECT_DOUBLE_EQ(t, 0.75);
  EXPECT_EQ(plane.intersectSegmentFrontAndBack(away, t, 1e-9), hduPlaned::ResultNone);
  EXPECT_EQ(plane.intersectSegmentFrontAndBack(along, t, 1e-9), hduPlaned::ResultNone);
  const hduLined line({0, 6, 0}, {0, 4, 0});
  EXPECT_EQ(plane.intersectLineFront(line, t, 1e-9), hduPlaned::ResultFront);  // a line goes on behind its points
  expectNear(line.evalPoint(t), {0, 3, 0});
  EXPECT_TRUE(line.isParallel(hduLined({5, 0, 0}, {5, 1, 0}), 1e-9));
  EXPECT_FALSE(line.isParallel(hduLined({5, 0, 0}, {6, 1, 0}), 1e-9));
}

TEST(HduWorkspace, FitsTheDeviceIntoTheView) {
  const double n = 1.0, f = 3.0;  // a symmetric frustum of 90 degrees, camera five units back
  const HDdouble projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -(f + n) / (f - n), -1, 0, 0, -2 * f * n / (f - n), 0};
  const HDdouble model[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5, 1};
  HDdouble mapped[16];
  hduMapWorkspaceModel(model, projection, mapped);
  const hduMatrix toWorld(mapped);
  expectNear(hduVector3Dd(0, 0, 0) * toWorld, {0, 0, 3}, 1e-9);               // the middle of the view's depth
  expectNear(hduVector3Dd(80, 0, 0) * toWorld, {1, 0, 3}, 1e-9);              // as wide as the view at its near plane
  const HDint viewport[4] = {0, 0, 200, 200};
  EXPECT_NEAR(hduScreenToWorkspaceScale(model, projection, viewport, mapped), 0.02, 1e-9);  // 4 units wide there, 200 pixels
}

using HduErrors = Hd;

TEST_F(HduErrors, AreSortedAndPrinted) {
  const auto error = [](HDerror code) { return HDErrorInfo{code, 0, 0}; };
  for (const HDerror code : {HD_WARM_MOTORS, HD_EXCEEDED_MAX_FORCE, HD_EXCEEDED_MAX_VELOCITY, HD_FORCE_ERROR}) {
    const HDErrorInfo info = error(code);
    EXPECT_TRUE(hduIsForceError(&info));
    EXPECT_FALSE(hduIsSchedulerError(&info));
  }
  const HDErrorInfo impulse = error(HD_EXCEEDED_MAX_FORCE_IMPULSE);
  EXPECT_FALSE(hduIsForceError(&impulse));
  for (const HDerror code : {HD_COMM_ERROR, HD_COMM_CONFIG_ERROR, HD_TIMER_ERROR, HD_INVALID_PRIORITY, HD_SCHEDULER_FULL}) {
    const HDErrorInfo info = error(code);
    EXPECT_TRUE(hduIsSchedulerError(&info));
  }
  std::ostringstream text;
  text << impulse;
  EXPECT_EQ(text.str().rfind("HD_EXCEEDED_MAX_FORCE_IMPULSE", 0), 0u);
}

TEST_F(HduErrors, RecordingsHoldALineATick) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  hdStartScheduler();
  ASSERT_TRUE(hduStartRecord(file, nullptr, nullptr, 20));
  inTicks(40, [&](int) {
    hdBeginFrame(device);
    hdEndFrame(device);
  });
  hdStopScheduler();
  std::rewind(file);
  int lines = 0;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) lines += c == '\n';
  std::fclose(file);
  EXPECT_EQ(lines, 20);
  EXPECT_TRUE(drain().empty());
}

}  // namespace
}  // namespace halsted::hdtest
