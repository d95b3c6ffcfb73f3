#pragma once
/// An open colon end with a purse-string under way, written down and not simulated: something to draw in tests and benchmarks.
#include "sim/exchange.h"

namespace halsted::render {

struct SyntheticSize { int around = 34, along = 18, threadNodes = 175; };

RenderScene syntheticScene(const SyntheticSize& = {});
/// `open` 1 is the rest shape; smaller values draw the rim together. `bites` of the running suture are in place.
RenderSnapshot syntheticSnapshot(const RenderScene&, double open, int bites);   // [1]
CameraView closeCamera();
/// The pose of a tool with its tip at `tip` and its shaft toward `hand`. `spin` turns the jaws about the shaft.
Pose toolPose(const Vec3& tip, const Vec3& hand, double spin);                  // [m], [m], [rad]

}  // namespace halsted::render
