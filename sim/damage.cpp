#include "sim/damage.h"

#include <cmath>

#include "sim/tools/instrument.h"
#include "sim/tools/standing_clamps.h"
#include "sim/tools/touch.h"

namespace halsted {
namespace {

constexpr double kPadLength = 7e-3;            // [m] of the jaws that tissue lies between

int index(Presser p) { return static_cast<int>(p); }

/// The part of a vertex's cell that is pressed: all of it by an instrument, a strip as wide as the strand by that.  [m^2]
double bearingArea(double cell, Presser by, double width) { return by == Presser::kInstrument ? cell : width * std::sqrt(cell); }   // [m^2] [m]

void press(const Model& m, int vertex, Presser by, double pressure, DamageWork& w) {   // [Pa]
  if (pressure <= 0.0 || m.surface.cell[vertex] <= 0.0) return;
  std::array<double, kPressers>& p = w.pressure[vertex];
  if (p[0] == 0.0 && p[1] == 0.0) w.pressed.push_back(vertex);   // within its capacity: every particle once
  p[index(by)] += pressure;
}

/// A push on a point of a triangle, shared among its corners.
void pressPoint(const Model& m, int triangle, const std::array<double, 3>& weight, Presser by, double force, double width, DamageWork& w) {   // [1] [N] [m]
  for (int k = 0; k < 3; ++k) {
    const int v = m.surface.triangles[triangle][k];
    if (m.surface.cell[v] > 0.0) press(m, v, by, weight[k] * force / bearingArea(m.surface.cell[v], by, width), w);
  }
}

void pressGrasp(const Model& m, const ToolParams& tool, const TissueGrasp& grasp, DamageWork& w) {
  const double pad = 2.0 * tool.jawRadius * kPadLength;          // [m^2]
  for (int g = 0; g < grasp.count; ++g)
    for (int k = 0; k < 3; ++k)
      press(m, m.surface.triangles[grasp.triangle[g]][k], Presser::kInstrument, grasp.weight[g][k] * grasp.force[g].norm() / (pad / grasp.count), w);
}

void gatherPushes(const Model& m, State& s) {
  DamageWork& w = s.work.damage;
  for (int hand = 0; hand < kHands; ++hand) {
    const ToolState& t = s.tools[hand];
    for (int i = 0; i < t.contactCount; ++i)
      pressPoint(m, t.contactTriangle[i], t.contactWeight[i], Presser::kInstrument, t.contactForce[i].dot(t.contactNormal[i]), 0.0, w);
    pressGrasp(m, toolOf(m, s, hand), t.grasp, w);
  }
  for (int k = 0; s.clamps && k < s.clamps->count; ++k) pressGrasp(m, clampOf(m, s.clamps->clamp[k]), s.clamps->clamp[k].grasp, w);
  const int triangles = static_cast<int>(m.surface.triangles.size());
  for (int i = 0; i < s.strand.contactCount; ++i) {
    const StrandContact& c = s.strand.contacts[i];
    if (c.feature >= triangles) continue;      // a tool, or the anvil
    const bool needle = c.sample >= m.strand.nodes && c.sample < m.strand.nodes + static_cast<int>(m.strand.sampleCoordinate.size());
    pressPoint(m, c.feature, c.weight, Presser::kStrand, c.normalForce, 2.0 * (needle ? m.strand.needle.wireRadius : m.strand.radius), w);
  }
}

/// What one cell bears in this step. Needle and thread are one presser: what they wear is a strip as wide as the thread.
void wear(const Model& m, int vertex, Presser by, double pressure, State& s) {   // [Pa]
  DamageMetrics& d = s.metrics.damage;
  const int k = index(by);
  d.peakPressure[k] = std::fmax(d.peakPressure[k], pressure);
  if (pressure <= kTraumaPressure) return;
  const double area = bearingArea(m.surface.cell[vertex], by, 2.0 * m.strand.radius), before = s.bruise[vertex][k];   // [m^2] [s]
  d.dose[k] += (pressure - kTraumaPressure) * area * m.params.dt;
  s.bruise[vertex][k] += m.params.dt;
  if (before < kTraumaTime && s.bruise[vertex][k] >= kTraumaTime) d.injured[k] += area;
}

}  // namespace

void beginDamage(const Model& m, State& s) {
  s.bruise.assign(m.mesh.vertices.size(), {});
  s.work.damage.pressure.assign(m.mesh.vertices.size(), {});
  s.work.damage.pressed.reserve(m.mesh.vertices.size());
}

void measureDamage(const Model& m, State& s) {
  for (int hand = 0; hand < kHands; ++hand) s.metrics.damage.forceTime[hand] += touchForce(s.tools[hand]).norm() * m.params.dt;
  gatherPushes(m, s);
  DamageWork& w = s.work.damage;
  for (const int vertex : w.pressed) {
    for (const Presser by : {Presser::kInstrument, Presser::kStrand}) wear(m, vertex, by, w.pressure[vertex][index(by)], s);
    w.pressure[vertex] = {};
  }
  w.pressed.clear();
}

}  // namespace halsted
