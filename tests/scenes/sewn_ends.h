#pragma once
/// Two bowel ends sewn end to end along their tops by stitches that are laid and drawn to length by the test, not by hands: what the
/// outcome's laws are about is spacing and depth, nothing else.
#include <algorithm>

#include "scenes/procedural_colon.h"
#include "scenes/two_ends.h"
#include "sim/contact/surface.h"
#include "sim/outcome.h"
#include "sim/step.h"
#include "sim/suture/holes.h"

namespace halsted {

struct Seam {
  int stitches = 5;
  double spacing = 4e-3, depth = 5e-3;         // [m] along the edge; from the edge
  double gap = 1e-3;                           // [m] between the edges before
  double press = 1.5e-3;                       // [m] by which drawn thread is shorter than at edges that just meet
  bool assist = false;                         // thread.assist = "knot"
  int spare = 0;                               // thread.spare
};

class SewnEnds {
 public:
  static constexpr double kRadius = 18e-3;     // [m]
  Model model;
  State state;
  StepInput input;
  StepOutput out;

  explicit SewnEnds(const Seam& seam, double holding = 10.0) : model(buildModel(params(seam, holding), ends(seam), {})), seam_(seam) {   // [N]
    for (int hand = 0; hand < kHands; ++hand) input.tools[hand].pose = {Vec3(hand == kLeft ? -0.06 : 0.06, 0.04, 0.08), Quat::Identity()};
    state = initialState(model, {input.tools[kLeft].pose, input.tools[kRight].pose});
    for (int i = 0; i < seam.stitches; ++i)
      for (int bowel = 0; bowel < 2; ++bowel) addHole(bowel, (i - 0.5 * (seam.stitches - 1)) * seam.spacing);
    state.strand.bitesBegun = 1;
    layThread();
    holdTails();
  }

  /// Draws each stitch to the length at which the edges meet and press on each other; the thread between stitches stays loose.
  void tighten() {
    constexpr int kSteps = 1000;
    StrandState& s = state.strand;
    const int middle = s.holeCount / 2;
    std::vector<double> move(s.holeCount, 0.0);   // [m]
    const auto across = [&](int i) { return i % 2 == 0 ? seam_.gap + seam_.press : 0.0; };   // [m] from this hole to the next
    for (int i = middle + 1; i < s.holeCount; ++i) move[i] = move[i - 1] - across(i - 1);
    for (int i = middle - 1; i >= 0; --i) move[i] = move[i + 1] + across(i);
    for (int k = 0; k < kSteps; ++k) {
      for (int i = 0; i < s.holeCount; ++i) s.holes[i].coordinate += move[i] / kSteps;
      state.tools[kLeft].threadCoordinate += move.front() / kSteps;
      state.tools[kRight].threadCoordinate += move.back() / kSteps;
      step();
    }
    for (int k = 0; k < 500; ++k) step();
  }
  /// A locked knot so near to the tissue.
  void tieOff(double close = 1e-3) {           // [m]
    AssistKnot& k = *state.assist;
    k.placed = k.locked = true;
    k.tail = state.strand.holes[0].coordinate - close;
    k.tip = state.strand.holes[state.strand.holeCount - 1].coordinate + close;
    k.apart = (strandPoint(model.strand, state.strand, k.tail) - strandPoint(model.strand, state.strand, k.tip)).norm();
    for (int i = 0; i < 500; ++i) step();
  }
  void letGo() {
    for (ToolSample& tool : input.tools) tool.jaw = 1.0;
    for (int i = 0; i < 1000; ++i) step();
  }
  void step() { halsted::step(model, input, state, out); }

 private:
  static SimParams params(const Seam& seam, double holding) {   // [N]
    SimParams p;
    p.gravity.setZero();
    p.anvil.radius = 0.0;
    p.tissue.youngsModulus = 400e3;            // as the scenes that sew end to end
    p.tissue.stiffening = 1.6;
    p.thread.nodes = 121;
    if (!seam.assist) p.thread.channelDrag = 1e4;                // each stitch keeps its length, as if it were tied
    p.thread.knots = seam.assist;
    p.thread.spare = seam.spare;
    p.thread.assistHolding = holding;
    p.thread.assist = seam.assist ? ThreadAssist::kKnot : ThreadAssist::kNone;
    return p;
  }
  static TetMesh ends(const Seam& seam) {
    AnatomyParams a;
    a.radius = kRadius;
    a.haustraDepth = 0.0;
    a.length = 40e-3;
    a.around = 48;
    a.along = 10;
    return scenes::endToEnd(scenes::proceduralColon(a), seam.gap);
  }
  static Vec3 tailWay(int hand) { return Vec3(hand == kLeft ? -0.3 : 0.3, 0.9, hand == kLeft ? -0.3 : 0.3).normalized(); }   // [1]

  /// In the middle of the wall, `along` [m] the edge from the top, as far from the edge as asked.
  void addHole(int bowel, double along) {
    const double angle = along / kRadius, x = (bowel == 0 ? -1.0 : 1.0) * (0.5 * seam_.gap + seam_.depth);   // [rad], [m]
    const double r = kRadius - 1e-3;           // [m]
    const Vec3 p(x, r * std::cos(angle) - kRadius, r * std::sin(angle));
    Hole& h = state.strand.holes[state.strand.holeCount];
    h.bite = 0;
    h.role = static_cast<std::int32_t>(HoleRole::kPassed);
    double best = -1e300;                      // [1] of the smallest weight: the facets lie a little inside the round wall
    for (std::size_t t = 0; t < model.tissue.tets.size(); ++t) {
      const auto& v = model.tissue.tets[t];
      Mat3 edges;
      for (int c = 0; c < 3; ++c) edges.col(c) = model.mesh.vertices[v[c + 1]] - model.mesh.vertices[v[0]];
      const Vec3 w = edges.inverse() * (p - model.mesh.vertices[v[0]]);
      const double least = std::min(w.minCoeff(), 1.0 - w.sum());
      if (least <= best) continue;
      best = least;
      h.tet = static_cast<std::int32_t>(t);
      h.weight = {1.0 - w.sum(), w.x(), w.y(), w.z()};
    }
    ++state.strand.holeCount;
  }

  /// Straight from hole to hole, the same length of tail at both ends.
  void layThread() {
    StrandState& s = state.strand;
    std::vector<Vec3> corner;                  // [m]
    double sewn = 0.0;                         // [m]
    for (int i = 0; i < s.holeCount; ++i) {
      corner.push_back(holePoint(model, s.holes[i], state.tissue.position));
      if (i > 0) sewn += (corner[i] - corner[i - 1]).norm();
    }
    const double tail = 0.5 * (model.strand.length - sewn);      // [m]
    corner.insert(corner.begin(), corner.front() + tail * tailWay(kLeft));
    corner.push_back(corner.back() + 2.0 * tail * tailWay(kRight));
    double before = 0.0;                       // [m]
    std::size_t leg = 0;
    for (int i = 0; i < model.strand.nodes; ++i) {
      while (leg + 2 < corner.size() && model.strand.place[i] > before + (corner[leg + 1] - corner[leg]).norm()) {
        before += (corner[leg + 1] - corner[leg]).norm();
        if (leg < static_cast<std::size_t>(s.holeCount)) s.holes[leg].coordinate = before;
        ++leg;
      }
      const Vec3 d = corner[leg + 1] - corner[leg];
      s.position[i] = corner[leg] + (model.strand.place[i] - before) / d.norm() * d;
    }
    s.needle.orientation = turnOnto(model.strand.arcTangent.front(), tailWay(kRight));
    s.needle.position += s.position.back() - s.needle.apply(model.strand.arcPoint.front());
  }

  /// Each tail in the jaws of a tool that stands where the tail is.
  void holdTails() {
    constexpr double kHeldAt = 25e-3;          // [m] from the tissue
    const StrandState& s = state.strand;
    for (int hand = 0; hand < kHands; ++hand) {
      ToolState& t = state.tools[hand];
      t.holdsNeedle = t.ratchet = false;
      t.closed = true;
      t.jaw = input.tools[hand].jaw = 0.0;
      t.threadCoordinate = hand == kLeft ? s.holes[0].coordinate - kHeldAt : s.holes[s.holeCount - 1].coordinate + kHeldAt;
      t.device = t.proxy = input.tools[hand].pose = Pose{strandPoint(model.strand, s, t.threadCoordinate), Quat::Identity()};
    }
  }

  Seam seam_;
};

}  // namespace halsted
