#include "sim/tools/touch.h"

#include <cmath>

#include "sim/tools/find_touch.h"
#include "sim/tools/standing_clamps.h"

namespace halsted {
namespace {

constexpr int kSweeps = 40;                    // Gauss-Seidel sweeps at most, started from the forces of the last step
constexpr double kSettled = 1e-3;              // [N] a sweep that changes no force by more than this is the last
constexpr double kLeastGive = 1e-6;            // [m/N] of tissue that is held in place

SurfacePlace placeOf(const TouchPoint& p) { return {p.triangle, p.weight}; }

void fillCompliance(const Model& m, State& s) {
  TouchWork& w = s.work.touch;
  for (int i = 0; i < w.count; ++i) {
    for (int j = i; j < w.count; ++j) {
      const TouchPoint &a = w.point[i], &b = w.point[j];
      const double coupling = a.hand == b.hand ? 1.0 / couplingOf(m, s, a.hand) : 0.0;
      const double c = surfaceCompliance(m, placeOf(a), placeOf(b)) + coupling;
      w.compliance[i * TouchWork::kMax + j] = c;
      w.compliance[j * TouchWork::kMax + i] = c;
    }
  }
}

/// Motion of tissue past tool at point i that the changes of force cause [m].
Vec3 response(const TouchWork& w, int i) {
  Vec3 u = Vec3::Zero();
  const double* row = &w.compliance[i * TouchWork::kMax];
  for (int j = 0; j < w.count; ++j) u += row[j] * (w.point[j].force - w.point[j].old);
  return u;
}

Vec3 limited(const Vec3& v, double limit) {
  const double length = v.norm();
  return length > limit ? Vec3(limit / length * v) : v;
}

/// One sweep over all points; returns the square of the largest change of a force.  [N^2]
double sweep(const Model& m, TouchWork& w) {
  double largest = 0.0;                        // [N^2]
  for (int i = 0; i < w.count; ++i) {
    TouchPoint& p = w.point[i];
    if (p.gone) continue;
    const Vec3 last = p.force;
    const Vec3 u = response(w, i);
    const double own = w.compliance[i * TouchWork::kMax + i];
    if (p.grasp) {
      p.force = limited(p.force - (p.slide + u) / own, p.slipLimit);
      largest = std::fmax(largest, (p.force - last).squaredNorm());
      continue;
    }
    const double normal = p.force.dot(p.normal);
    const double pushed = std::fmax(0.0, normal - (p.gap + u.dot(p.normal)) / own);
    const Vec3 tangent = p.force - normal * p.normal;
    const Vec3 slide = p.slide + u - u.dot(p.normal) * p.normal;
    p.force = pushed * p.normal + limited(tangent - slide / own, m.params.contact.toolTissueFriction * pushed);
    largest = std::fmax(largest, (p.force - last).squaredNorm());
  }
  return largest;
}

void addNodal(const Model& m, int triangle, const std::array<double, 3>& weight, const Vec3& f, std::vector<Vec3>& nodal) {
  const auto& v = m.surface.triangles[triangle];
  for (int k = 0; k < 3; ++k) nodal[v[k]] += weight[k] * f;
}

void addGrasp(const Model& m, const TissueGrasp& grasp, double sign, std::vector<Vec3>& nodal) {   // [1] [N]
  for (int g = 0; g < grasp.count; ++g) addNodal(m, grasp.triangle[g], grasp.weight[g], sign * grasp.force[g], nodal);
}

void clearContacts(int from, ToolState& t) {
  t.contactCount = from;
  for (int k = from; k < ToolState::kMaxContacts; ++k) {
    t.contactTriangle[k] = -1;
    t.contactWeight[k] = {};
    t.contactNormal[k] = t.contactForce[k] = Vec3::Zero();
  }
}

/// Replaces the tool's stored contacts by the ones just solved.
void store(const Model& m, State& s) {
  std::array<int, kHands + kMostClamps> grasp{};
  std::array<int, kHands> contact{};
  for (int i = 0; i < s.work.touch.count; ++i) {
    const TouchPoint& p = s.work.touch.point[i];
    if (p.gone) continue;
    addNodal(m, p.triangle, p.weight, p.force, s.work.change);
    if (p.grasp) { graspOf(s, p.hand).force[grasp[p.hand]++] = p.force; continue; }
    if (p.force.squaredNorm() <= 0.0) continue;
    ToolState& t = s.tools[p.hand];
    const int k = contact[p.hand]++;
    t.contactTriangle[k] = p.triangle;
    t.contactWeight[k] = p.weight;
    t.contactNormal[k] = p.normal;
    t.contactForce[k] = p.force;
  }
  for (int hand = 0; hand < kHands; ++hand) clearContacts(contact[hand], s.tools[hand]);
}

}  // namespace

void solveTouch(const Model& m, const std::array<Pose, kHands>& before, State& s) {
  s.work.touch.count = 0;
  for (int hand = 0; hand < kHands; ++hand) {
    refreshNear(m, hand, s);
    findContacts(m, hand, before[hand], s);
    findGrasps(m, hand, s);
  }
  findStandingGrasps(m, s);
  fillCompliance(m, s);
  for (int k = 0; k < kSweeps && sweep(m, s.work.touch) > kSettled * kSettled; ++k) {}
  for (const ToolState& t : s.tools) {         // what was carried into the step is replaced by what `store` adds
    for (int i = 0; i < t.contactCount; ++i) addNodal(m, t.contactTriangle[i], t.contactWeight[i], -t.contactForce[i], s.work.change);
    addGrasp(m, t.grasp, -1.0, s.work.change);
  }
  for (int k = 0; s.clamps && k < s.clamps->count; ++k) addGrasp(m, s.clamps->clamp[k].grasp, -1.0, s.work.change);
  store(m, s);
}

void gatherTouchForces(const Model& m, const State& s, std::vector<Vec3>& nodal) {
  for (const ToolState& t : s.tools) {
    for (int i = 0; i < t.contactCount; ++i) addNodal(m, t.contactTriangle[i], t.contactWeight[i], t.contactForce[i], nodal);
    addGrasp(m, t.grasp, 1.0, nodal);
  }
  for (int k = 0; s.clamps && k < s.clamps->count; ++k) addGrasp(m, s.clamps->clamp[k].grasp, 1.0, nodal);
}

void dropContacts(const Model& m, int hand, State& s) {
  ToolState& t = s.tools[hand];
  for (int i = 0; i < t.contactCount; ++i) addNodal(m, t.contactTriangle[i], t.contactWeight[i], -t.contactForce[i], s.work.change);
  clearContacts(0, t);
}

double surfaceCompliance(const Model& m, const SurfacePlace& a, const SurfacePlace& b) {
  const auto &u = m.surface.triangles[a.triangle], &v = m.surface.triangles[b.triangle];
  double sum = 0.0;                            // [m/N]
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += a.weight[i] * b.weight[j] * compliance(m.tissue.projective, u[i], v[j]);
  return sum;
}

double touchCompliance(const Model& m, const TouchPoint& p) { return surfaceCompliance(m, placeOf(p), placeOf(p)); }

Vec3 contactForce(const ToolState& t) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < t.contactCount; ++i) sum -= t.contactForce[i];
  return sum;
}

Vec3 touchForce(const ToolState& t) {
  Vec3 sum = contactForce(t);
  for (int g = 0; g < t.grasp.count; ++g) sum -= t.grasp.force[g];
  return sum;
}

namespace {

/// A held point resists in every direction; one that slides no longer along the force that makes it slide.  [1]
Mat3 graspShare(const TouchPoint& p) {
  const double size = p.force.norm();          // [N]
  if (size < 0.999 * p.slipLimit || size <= 0.0) return Mat3::Identity();
  const Vec3 d = p.force / size;
  return Mat3::Identity() - d * d.transpose();
}

}  // namespace

Mat3 touchStiffness(const Model& m, const State& s, int hand) {
  const TouchWork& w = s.work.touch;
  Mat3 k = Mat3::Zero();
  for (int i = 0; i < w.count; ++i) {
    const TouchPoint& p = w.point[i];
    if (p.hand != hand || (!p.grasp && p.force.squaredNorm() <= 0.0)) continue;
    double row = 0.0;                          // [m/N] what the point gives when all points of this tool are pushed alike
    for (int j = 0; j < w.count; ++j) {
      const TouchPoint& q = w.point[j];
      if (q.hand == hand && (q.grasp || q.force.squaredNorm() > 0.0)) row += std::fabs(surfaceCompliance(m, placeOf(p), placeOf(q)));
    }
    row = std::fmax(row, kLeastGive);
    const double normal = p.force.dot(p.normal);
    const double tangential = (p.force - normal * p.normal).norm();
    const bool sticks = tangential < 0.99 * m.params.contact.toolTissueFriction * normal;
    k += (p.grasp ? graspShare(p) : sticks ? Mat3(Mat3::Identity()) : Mat3(p.normal * p.normal.transpose())) / row;
  }
  return k;
}

}  // namespace halsted
