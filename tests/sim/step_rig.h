#pragma once
/// A standing wall of tissue, 4 mm thick unless a test says otherwise, fixed at its foot, with both tools, needle and thread: the whole step without a scene.
///   x through the wall (faces at 0 and 4 mm), y along it, z up (foot at 0, top edge at 16 mm). Weightless unless a test sets gravity.
#include <cmath>
#include <stdexcept>

#include "sim/step.h"
#include "sim/suture/holes.h"
#include "sim/tissue/tissue.h"

namespace halsted {

inline constexpr double kWallX = 4e-3, kWallY = 24e-3, kWallZ = 16e-3;   // [m]

inline TetMesh wallMesh(double thickness = kWallX) {   // [m]
  TetMesh mesh = blockMesh(2, 12, 8, Vec3(thickness, kWallY, kWallZ));
  for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i)
    if (mesh.vertices[i].z() < 1e-9) mesh.fixed.push_back(i);
  for (const Vec3& corner : {Vec3(0, 0, kWallZ), Vec3(thickness, 0, kWallZ), Vec3(thickness, kWallY, kWallZ), Vec3(0, kWallY, kWallZ)})
    for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i)
      if ((mesh.vertices[i] - corner).norm() < 1e-9) mesh.rim.push_back(i);
  return mesh;
}

inline SimParams wallParams() {
  SimParams p;
  p.gravity.setZero();
  p.tissue.youngsModulus = 1e6;                // the large-strain 0.63 to 1.76 MPa: this wall stands alone and must not fold over
  p.tissue.stiffening = 1.0;                   // past the toe already
  p.thread.nodes = 60;
  p.anvil.from = Vec3(0.3, 0.3, 0.3);          // out of the way
  p.anvil.to = Vec3(0.3, 0.3, 0.33);
  return p;
}

/// Pose whose frame has these axes [1] as its x and y.
inline Pose frame(const Vec3& origin, const Vec3& x, const Vec3& y) {   // origin [m]
  Mat3 axes;
  axes.col(0) = x;
  axes.col(1) = y;
  axes.col(2) = x.cross(y);
  return {origin, Quat(axes).normalized()};
}

inline const Pose kAway{Vec3(-0.15, -0.15, 0.15), Quat::Identity()};   // a tool that touches nothing

inline const Pose kNeedleAway{Vec3(0.15, 0.15, 0.15), Quat::Identity()};   // thread straight and free of force behind it

/// The material point that lies at a place of the tissue at rest.
inline TissuePoint tissuePointAt(const Model& m, const Vec3& p) {   // [m]
  for (std::size_t t = 0; t < m.tissue.tets.size(); ++t) {
    const auto& v = m.tissue.tets[t];
    Mat3 edges;
    for (int c = 0; c < 3; ++c) edges.col(c) = m.mesh.vertices[v[c + 1]] - m.mesh.vertices[v[0]];
    const Vec3 w = edges.inverse() * (p - m.mesh.vertices[v[0]]);
    if (w.minCoeff() >= -1e-9 && w.sum() <= 1.0 + 1e-9) return {static_cast<std::int32_t>(t), {1.0 - w.sum(), w.x(), w.y(), w.z()}};
  }
  throw std::logic_error("no tissue is there");
}

/// The right hand holds the needle as it was loaded; the left hand starts where told, jaws open.
struct StepRig {
  Model model;
  State state;
  StepInput input;
  StepOutput out;

  StepRig(const SimParams& p, const Pose& needle, const Pose& left = kAway, double thickness = kWallX) : model(buildModel(p, wallMesh(thickness), {})) {   // [m]
    const Pose inTool = initialState(model, {Pose{}, Pose{}}).tools[kRight].needleInTool;
    const Pose right = compose(needle, inverse(inTool));
    state = initialState(model, {left, right});
    input.tools[kLeft].pose = left;
    input.tools[kRight].pose = right;
    input.tools[kRight].jaw = 0.0;
  }

  void step() {
    for (ToolSample& sample : input.tools) ++sample.tick;
    halsted::step(model, input, state, out);
  }
  void run(int steps) {
    for (int k = 0; k < steps; ++k) step();
  }
  /// Where the right hand must be for the needle to have this pose.
  void needleTo(const Pose& needle) { input.tools[kRight].pose = compose(needle, inverse(state.tools[kRight].needleInTool)); }

  bool happened(EventKind kind) const {        // in the last step
    for (int i = 0; i < out.eventCount; ++i)
      if (out.events[i].kind == kind) return true;
    return false;
  }

  double tissueSpeed() const {                 // [m/s]
    double most = 0.0;                         // [m/s]
    for (const Vec3& v : state.tissue.velocity) most = std::max(most, v.norm());
    return most;
  }
  double displacement() const {                // [m] largest, from the rest shape
    double most = 0.0;                         // [m]
    for (std::size_t i = 0; i < state.tissue.position.size(); ++i)
      most = std::max(most, (state.tissue.position[i] - model.mesh.vertices[i]).norm());
    return most;
  }
  bool finite() const {
    for (std::size_t i = 0; i < state.tissue.position.size(); ++i)
      if (!state.tissue.position[i].allFinite() || !state.tissue.velocity[i].allFinite()) return false;
    for (std::size_t i = 0; i < state.strand.position.size(); ++i)
      if (!state.strand.position[i].allFinite() || !state.strand.velocity[i].allFinite()) return false;
    for (const ToolState& t : state.tools)
      if (!t.force.allFinite() || !t.proxy.position.allFinite() || !t.proxy.orientation.coeffs().allFinite()) return false;
    for (const LocalContact& c : out.contact)
      if (!c.force.allFinite() || !c.stiffness.allFinite() || !c.damping.allFinite()) return false;
    return state.strand.needle.position.allFinite() && state.strand.needle.orientation.coeffs().allFinite();
  }
};

}  // namespace halsted
