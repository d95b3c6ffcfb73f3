#include "sim/needling/body_model.h"

#include <stdexcept>

#include "sim/params.h"

namespace halsted {
namespace {

void findHands(const SimParams& p, BodyModel& m) {
  const bool leftHolds = p.tools[kLeft].kind == ToolKind::kAcupunctureNeedle;
  m.needleHand = leftHolds ? kLeft : kRight;
  m.fingerHand = leftHolds ? kRight : kLeft;
  if (p.tools[m.needleHand].kind != ToolKind::kAcupunctureNeedle || p.tools[m.fingerHand].kind != ToolKind::kFinger)
    throw std::invalid_argument("tool: one hand must have kind acupuncture_needle, the other finger");
}

}  // namespace

BodyModel buildBody(const SimParams& params, const Body& body) {
  if (body.empty()) throw std::invalid_argument("anatomy: there is no body to be needled");
  if (body.points.empty()) throw std::invalid_argument("anatomy: the body has no acupoint");
  if (body.target < 0 || body.target >= static_cast<int>(body.points.size())) throw std::invalid_argument("anatomy: no such acupoint");
  BodyModel m;
  NeedlingParams p = params.needling;
  p.dt = params.dt;
  std::array<HarmonicSurface, kLayers> surfaces;
  for (int k = 0; k < kLayers; ++k) {
    p.layers[k].thickness = body.thickness[k];
    surfaces[k] = harmonicSurface(body.order, body.surface[k]);
  }
  m.needling = needlingModel(p, surfaces);
  m.points = body.points;
  m.target = body.target;
  for (const Acupoint& point : m.points) m.places.push_back(frameAt(surfaces[0], point.unit));
  findHands(params, m);
  m.picture = bodyPicture(m.needling, m.targetPlace());
  return m;
}

int netPoints(const NeedlingModel& m) {
  int sum = 0;
  for (const ForceNet& net : m.net) sum += netPoints(net.rings);
  return sum;
}

}  // namespace halsted
