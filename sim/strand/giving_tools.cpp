#include "sim/strand/giving_tools.h"

#include <algorithm>

namespace halsted {
namespace {

using HandRows = Eigen::Map<Vec3>;

HandRows rowsOf(int hand, std::vector<double>& x) { return HandRows(x.data() + x.size() - 3 * (kHands - hand)); }   // [N] or [m]

}  // namespace

void beginHands(GivingTools& g) {
  for (GivingTool& t : g.tool) t.shift = t.correction = Vec3::Zero();
}

void assembleHands(GivingTools& g, std::vector<double>& rhs, CoupledSolve& coupled) {   // [N]
  for (int hand = 0; hand < kHands; ++hand) {
    const GivingTool& t = g.tool[hand];
    g.touched[hand] = false;
    rowsOf(hand, rhs) = -t.spring * (t.offset + t.shift);
    if (!coupled.holdsHand(hand)) continue;
    const int block = coupled.handBlock(hand);
    coupled.add(block, block, t.spring * Mat3::Identity());
  }
}

void addToHand(int hand, const CurveWeights& sample, const Vec3& force, const Mat3& stiffness, GivingTools& g, std::vector<double>& rhs, CoupledSolve& coupled) {   // [N], [N/m]
  if (!coupled.holdsHand(hand)) return;
  const int block = coupled.handBlock(hand);
  g.touched[hand] = true;
  rowsOf(hand, rhs) -= force;
  coupled.add(block, block, stiffness);
  for (int a = 0; a < 3; ++a) coupled.add(block, sample.node + a, -sample.weight[a] * stiffness);
}

void readHands(std::vector<double>& x, const CoupledSolve& coupled, GivingTools& g) {   // [N] then [m]
  g.moved = 0.0;
  for (int hand = 0; hand < kHands; ++hand) {
    GivingTool& t = g.tool[hand];
    HandRows own = rowsOf(hand, x);
    if (!coupled.holdsHand(hand) && t.spring > 0.0) own /= t.spring;
    t.correction = own;
    if (g.touched[hand]) g.moved = std::max(g.moved, t.correction.norm());
  }
}

void shiftHands(double share, GivingTools& g) {   // [1]
  for (GivingTool& t : g.tool) t.shift += share * t.correction;
}

void settleHands(GivingTools& g) {
  for (GivingTool& t : g.tool) {
    t.offset += t.shift;
    t.shift.setZero();
  }
}

}  // namespace halsted
