#pragma once
/// Matrices of the eye and of the lamp. Column vectors, right-handed, OpenGL clip space.
#include "sim/exchange.h"

namespace halsted::render {

using Matrix4 = Eigen::Matrix4f;

Matrix4 viewProjection(const CameraView&, double aspect);              // [1] width / height
/// Parallel light along `lightDirection` over a ball.
Matrix4 lampProjection(const Vec3& centre, double radius);             // [m]
/// From clip space to the [0, 1] cube that a shadow lookup wants.
Matrix4 toTexture(const Matrix4& clip);
Matrix4 matrixOf(const Pose&);
/// Size of a pixel at distance 1.
double pixelSize(const CameraView&, int height);                       // [1]

}  // namespace halsted::render
