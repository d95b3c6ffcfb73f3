#pragma once
/// A strip of tissue that can be cut across, with an electrocautery pen in the left hand; needle and thread lie far away.
///   8 mm wide (x), 4 mm thick (y), 20 mm long (z), in cells of 2 mm; rows 4 to 6 can be cut, the line runs through row 5 (z 10 to 12 mm).
///   Held at its upper end z = 20 mm, or at both; what is below the line is the specimen.
#include "sim/cutting/cut_measure.h"
#include "sim/cutting/loose_ends.h"
#include "sim/cutting/pieces.h"
#include "tests/sim/step_rig.h"

namespace halsted {

inline constexpr int kStripX = 4, kStripY = 2, kStripZ = 10, kLineRow = 5;
inline constexpr double kCell = 2e-3;          // [m]
inline constexpr double kRowVolume = kStripX * kStripY * kCell * kCell * kCell;   // [m^3]

inline int stripRow(int tet) { return tet / 6 / (kStripX * kStripY); }

enum class Held { kTop, kBothEnds };

inline TetMesh stripMesh(Held held, bool cuttable = true) {
  TetMesh mesh = blockMesh(kStripX, kStripY, kStripZ, kCell * Vec3(kStripX, kStripY, kStripZ));
  for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i) {
    const double z = mesh.vertices[i].z();     // [m]
    if (z > kStripZ * kCell - 1e-9 || (held == Held::kBothEnds && z < 1e-9)) mesh.fixed.push_back(i);
  }
  mesh.rim = {0, 1, 2};
  if (!cuttable) return mesh;
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
    const int row = stripRow(t), off = kLineRow - row;             // positive below the line
    mesh.cuttable.push_back(off >= -1 && off <= 1);
    mesh.cutLine.push_back(mesh.cuttable.back() ? CutMark{0, t / 6 % kStripX, off * kCell} : CutMark{});
  }
  return mesh;
}

/// Soft, weightless and undamped; a hundredth of the true energy, so that a cut takes half a second.
inline SimParams cutParams() {
  SimParams p = wallParams();
  p.tissue.youngsModulus = 120e3;
  p.tools[kLeft].kind = ToolKind::kElectrocautery;
  p.cautery.cuttingEnergy = 1e8;
  return p;
}

/// The pen comes along -y at the face y = 4 mm: its electrode's surface `depth` below that face.  [m]
inline Pose penAt(double x, double depth, double z) {
  return frame(Vec3(x, kStripY * kCell + 0.6e-3 - depth, z), Vec3::UnitZ(), Vec3::UnitX());
}

struct CutRig {
  Model model;
  State state;
  StepInput input;
  StepOutput out;

  explicit CutRig(const SimParams& p = cutParams(), Held held = Held::kTop) : CutRig(p, stripMesh(held)) {}
  CutRig(const SimParams& p, TetMesh mesh, const Pose& right = kNeedleAway) : model(buildModel(p, std::move(mesh), {})) {
    state = initialState(model, {kAway, right});
    input.tools[kLeft].pose = kAway;
    input.tools[kRight].pose = state.tools[kRight].device;
    input.tools[kRight].jaw = 0.0;
  }
  void step() {
    for (ToolSample& sample : input.tools) ++sample.tick;
    halsted::step(model, input, state, out);
    for (int i = 0; i < out.eventCount; ++i) seen[static_cast<std::size_t>(out.events[i].kind)] += 1;
  }
  void run(int steps) {
    for (int k = 0; k < steps; ++k) step();
  }
  void pen(const Pose& pose, bool on) {
    input.tools[kLeft].pose = pose;
    input.tools[kLeft].jaw = on ? 0.0 : 1.0;
  }
  /// Draws the pen to and fro across the strip, half a millimetre deeper each time, as far as `steps` go. Returns the steps used.
  int saw(int steps, int from = 0) {
    constexpr int kStroke = 240;               // steps for 9.6 mm: 40 mm/s
    for (int k = from; k < from + steps; ++k) {
      const double way = static_cast<double>(k % kStroke) / kStroke;                       // [1]
      const double across = k / kStroke % 2 ? 1.0 - way : way;                           // [1]
      pen(penAt(-0.8e-3 + 9.6e-3 * across, 0.1e-3 + 0.4e-3 * (k / kStroke), (kLineRow + 0.5) * kCell), true);
      step();
    }
    return from + steps;
  }
  /// All of a row at once, as if it had been burnt in this moment.
  void vaporise(int row) {
    for (int t = 0; t < static_cast<int>(model.mesh.tets.size()); ++t) {
      if (stripRow(t) != row) continue;
      state.tissue.gone[t] = static_cast<std::uint8_t>(Gone::kBurnt);
      state.tissue.heat[t] = model.tissue.restVolume[t] * model.params.cautery.cuttingEnergy;
    }
    out.eventCount = 0;
    settlePieces(model, state, out);
    letGoOfGone(model, state, out);
    measureCut(model, state);
    for (int i = 0; i < out.eventCount; ++i) seen[static_cast<std::size_t>(out.events[i].kind)] += 1;
  }

  /// Gives the first free piece this speed along z.  [m/s]
  void throwFree(double speed) {
    for (std::size_t i = 0; i < state.tissue.velocity.size(); ++i)
      if (state.tissue.piece[i] == 1) state.tissue.velocity[i] = Vec3(0.0, 0.0, speed);
  }

  CutRig(const CutRig&) = default;
  CutRig& operator=(const CutRig&) = default;
  const CutMetrics& cut() const { return *state.metrics.cut; }
  double heat() const {                        // [J]
    double sum = 0.0;                          // [J]
    for (double h : state.tissue.heat) sum += h;
    return sum;
  }
  /// Mean over the particles of the free part, below the line.
  Vec3 freeVelocity() const { return mean(state.tissue.velocity); }      // [m/s]
  Vec3 freePlace() const { return mean(state.tissue.position); }         // [m]
  double kinetic() const {                     // [J]
    double sum = 0.0;                          // [J]
    for (std::size_t i = 0; i < model.tissue.mass.size(); ++i) sum += 0.5 * model.tissue.mass[i] * state.tissue.velocity[i].squaredNorm();
    return sum;
  }
  /// Of the weight that is left.
  double potential() const {                   // [J]
    double sum = 0.0;                          // [J]
    for (std::size_t i = 0; i < model.tissue.mass.size(); ++i)
      sum -= model.tissue.mass[i] * state.tissue.left[i] * model.params.gravity.dot(state.tissue.position[i]);
    return sum;
  }
  double elastic() const { return elasticEnergy(model.tissue, state.tissue); }   // [J]
  int count(EventKind kind) const { return seen[static_cast<std::size_t>(kind)]; }

  std::array<int, 64> seen{};                  // events, by kind

 private:
  Vec3 mean(const std::vector<Vec3>& field) const {
    Vec3 sum = Vec3::Zero();
    int n = 0;
    for (std::size_t i = 0; i < field.size(); ++i) {
      if (model.mesh.vertices[i].z() > kLineRow * kCell + 1e-9) continue;
      sum += field[i];
      ++n;
    }
    return sum / n;
  }
};

}  // namespace halsted
