#include "haptics/bench/block.h"

#include <cmath>

namespace halsted::haptics::bench {

namespace {

constexpr double kJaw = 1.2e-3;                // [m] radius of the jaws' rounded end (ToolParams)

bool held(const Vec3& v, const BlockShape& shape) {   // [m] of a vertex
  const double near = 1e-9;                    // [m]
  if (!shape.sheet) return v.z() < -shape.size.z() + near;
  const double x = std::abs(v.x()), y = std::abs(v.y());   // [m]
  return x > 0.5 * shape.size.x() - near || y > 0.5 * shape.size.y() - near;
}

TetMesh meshOf(const BlockShape& shape) {
  TetMesh mesh = blockMesh(shape.nx, shape.ny, shape.nz, shape.size);
  const Vec3 half(0.5 * shape.size.x(), 0.5 * shape.size.y(), shape.size.z());
  for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i) {
    mesh.vertices[i] -= half;
    if (held(mesh.vertices[i], shape)) mesh.fixed.push_back(i);
  }
  for (const double corner : {0.0, 1.0, 2.0, 3.0}) {   // the rim that an anatomy has: here the top's four corners
    const Vec3 at((corner == 1.0 || corner == 2.0 ? 1.0 : -1.0) * half.x(), (corner >= 2.0 ? 1.0 : -1.0) * half.y(), 0.0);
    for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i)
      if ((mesh.vertices[i] - at).norm() < 1e-9) mesh.rim.push_back(i);
  }
  return mesh;
}

}  // namespace

Pose farAway() { return {Vec3(0.15, 0.15, 0.15), Quat::Identity()}; }

Pose above(double x, double y, double gap) { return {Vec3(x, y, gap + kJaw), Quat::Identity()}; }

Model blockModel(const BlockShape& shape) {
  SimParams params;
  params.gravity.setZero();
  params.tissue.youngsModulus = shape.youngsModulus;
  params.tissue.stiffening = 1.0;              // past the toe already
  params.contact.toolTissueFriction = shape.friction;
  params.thread.nodes = 60;
  params.anvil.from = Vec3(0.3, 0.3, 0.3);     // out of the way
  params.anvil.to = Vec3(0.3, 0.3, 0.33);
  return buildModel(params, meshOf(shape), {});
}

BlockStep::BlockStep(const Model& m, const std::array<Pose, kHands>& start) : model(m), state(initialState(m, {start[kLeft], farAway()})) {
  ToolState& right = state.tools[kRight];      // leaves needle and thread where they lie, far away, and comes with empty jaws
  right.holdsNeedle = false;
  right.device = right.proxy = start[kRight];
  for (ToolState& tool : state.tools) {        // closed already: jaws that close near tissue would grasp it
    tool.jaw = 0.0;
    tool.closed = true;
  }
  for (int hand = 0; hand < kHands; ++hand) {
    input.tools[hand].pose = start[hand];
    input.tools[hand].jaw = 0.0;
  }
}

LocalContact BlockStep::step(const ToolSample& sample, double) {   // [s]
  input.tools[kLeft] = sample;
  stepBoth();
  return output.contact[kLeft];
}

void BlockStep::stepBoth() {
  for (ToolSample& tool : input.tools) tool.jaw = 0.0;
  halsted::step(model, input, state, output);
}

}  // namespace halsted::haptics::bench
