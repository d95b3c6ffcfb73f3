#pragma once
/// What an acupuncturist reads: the point and its textbook depth and angle, where the needle is, what it meets.
#include "sim/exchange.h"

namespace halsted::render {

struct Pen;
struct HudSize { float width, height; };                 // [pixels] of a 720-line picture

void drawNeedling(const Pen&, const HudSize&, const LayeredBody&, const RenderSnapshot&, const CameraView&);

}  // namespace halsted::render
