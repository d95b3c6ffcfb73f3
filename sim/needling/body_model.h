#pragma once
/// The needled body as the step, the procedure and the picture see it. Built once, then constant.
#include "sim/needling/body.h"
#include "sim/needling/body_picture.h"
#include "sim/needling/needling.h"

namespace halsted {

struct SimParams;

struct BodyModel {
  NeedlingModel needling;
  std::vector<Acupoint> points;
  std::vector<SurfaceFrame> places;            // of the points, on the skin at rest
  int target = 0;
  int needleHand = kRight, fingerHand = kLeft;
  BodyPicture picture;

  const Acupoint& targetPoint() const { return points[target]; }
  const SurfaceFrame& targetPlace() const { return places[target]; }
};

/// Throws std::invalid_argument naming what makes no sense.
BodyModel buildBody(const SimParams&, const Body&);

int netPoints(const NeedlingModel&);

}  // namespace halsted
