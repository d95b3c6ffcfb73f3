#pragma once
/// A body of three layers with a cutaway, an acupuncture needle and a pressing finger, written down and not simulated: something to draw.
#include "sim/exchange.h"

namespace halsted::render {

RenderScene syntheticBody();
/// The needle upright over the target, its tip `depth` below the skin (negative: above it); the skin dented by `dimple`.  [m]
RenderSnapshot syntheticNeedling(const RenderScene&, double depth, double dimple);

}  // namespace halsted::render
