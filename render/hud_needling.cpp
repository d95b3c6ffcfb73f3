#include "render/hud_needling.h"

#include <cmath>
#include <numbers>

#include "render/body_stand.h"
#include "render/camera.h"
#include "render/hud_pen.h"
#include "render/magnifier.h"

namespace halsted::render {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;    // [1]
constexpr ImU32 kLayerColors[3] = {IM_COL32(236, 190, 168, 255), IM_COL32(238, 196, 84, 255), IM_COL32(196, 62, 54, 255)};
const char* const kLayerNames[4] = {"outside", "skin", "fat", "muscle"};

/// Names beside the points that face the eye.
void drawNames(const Pen& pen, const HudSize& size, const LayeredBody& body, const CameraView& camera) {
  const Matrix4 view = viewProjection(camera, size.width / size.height);
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    const AcupointMark& point = body.points[i];
    if (point.normal.dot(camera.eye - point.place) <= 0.0) continue;
    const Eigen::Vector4f clip = view * Eigen::Vector4f(static_cast<float>(point.place.x()), static_cast<float>(point.place.y()), static_cast<float>(point.place.z()), 1.0f);
    if (clip.w() <= 0.0f || std::abs(clip.x()) > clip.w() || std::abs(clip.y()) > clip.w()) continue;
    const float x = 0.5f * size.width * (1.0f + clip.x() / clip.w()), y = 0.5f * size.height * (1.0f - clip.y() / clip.w());   // pixels
    const bool target = static_cast<int>(i) == body.target;
    const ImU32 ink = target ? IM_COL32(96, 44, 150, 255) : IM_COL32(96, 44, 150, 170);
    const float left = x - 46.0f - pen.width(point.id.c_str(), 14);                // pixels
    pen.list->AddLine(pen.at(x - (target ? 25.0f : 9.0f), y + 3.0f), pen.at(x - 42.0f, y + 12.0f), ink, 1.2f * pen.scale);
    pen.text(left, y + 5.0f, ink, point.id.c_str(), 14);
  }
}

/// How deep the needle stands in what, beside the depth that the point asks for.
void drawGauge(const Pen& pen, const HudSize& size, const AcupointMark* target, const NeedlingView& needle) {
  constexpr float kHeight = 210.0f, kDeepest = 40.0f;    // pixels, [mm]
  const float x = size.width - 92.0f, top = size.height - 320.0f, scale = kHeight / kDeepest;   // pixels, pixels, pixels a millimetre
  pen.panel(x - 64.0f, top - 34.0f, 144.0f, kHeight + 56.0f);
  pen.text(x - 52.0f, top - 28.0f, kDim, "depth, mm", 12);
  pen.list->AddRectFilled(pen.at(x, top), pen.at(x + 18.0f, top + kHeight), kTrack);
  float from = top;                                      // pixels
  for (int k = 0; k < 3; ++k) {
    const float length = std::min(static_cast<float>(1e3 * needle.inside[static_cast<std::size_t>(k)]) * scale, top + kHeight - from);   // pixels
    if (length > 0.0f) pen.list->AddRectFilled(pen.at(x, from), pen.at(x + 18.0f, from + length), kLayerColors[k]);
    if (length > 12.0f) pen.text(x + 24.0f, from + 0.5f * length - 8.0f, kLayerColors[k], kLayerNames[k + 1], 12);
    from += std::max(length, 0.0f);
  }
  for (int mm = 0; mm <= 40; mm += 10) {
    pen.list->AddLine(pen.at(x - 6.0f, top + static_cast<float>(mm) * scale), pen.at(x, top + static_cast<float>(mm) * scale), kDim, pen.scale);
    char text[8];
    std::snprintf(text, sizeof text, "%d", mm);
    pen.text(x - 24.0f, top + static_cast<float>(mm) * scale - 8.0f, kDim, text, 12);
  }
  if (!target) return;
  const float y = top + std::min(static_cast<float>(1e3 * target->depth), kDeepest) * scale;     // pixels
  pen.list->AddLine(pen.at(x - 8.0f, y), pen.at(x + 26.0f, y), kGood, 2.0f * pen.scale);
}

void drawReadings(const Pen& pen, const HudSize& size, const AcupointMark* target, const RenderSnapshot& s) {
  const NeedlingView& n = s.needling;
  const double depth = 1e3 * std::max(n.depth, 0.0), angle = kDegrees * n.angle;   // [mm] [deg]
  const double wantedDepth = target ? 1e3 * target->depth : depth, wantedAngle = target ? kDegrees * target->angle : angle;   // [mm] [deg]
  const ImU32 deep = n.punctured <= 0 ? kDim : std::abs(depth - wantedDepth) < 2.0 ? kGood : kText;
  const ImU32 tilted = std::abs(angle - wantedAngle) < 15.0 ? kGood : kWarn;
  pen.readings({0.5f * size.width, size.height - 62.0f}, 96.0f, 16.0f,
               {reading("time", kText, "%.1f s", s.time),
                target ? reading("depth", deep, "%.1f / %.0f mm", depth, wantedDepth) : reading("depth", deep, "%.1f mm", depth),
                target ? reading("angle", tilted, "%.0f / %.0f\xc2\xb0", angle, wantedAngle) : reading("angle", tilted, "%.0f\xc2\xb0", angle),
                reading("tip in", kText, "%s", kLayerNames[std::clamp(n.punctured, 0, 3)]),
                reading("turned", kText, "%+.0f\xc2\xb0", kDegrees * n.turned),
                reading("grasp", n.grasp >= 1.3 ? kGood : kText, "%.2f x", n.grasp), reading("faults", s.faults ? kBad : kGood, "%u", s.faults)});
}

void drawTarget(const Pen& pen, const HudSize& size, const AcupointMark& target) {
  char line[160];
  std::snprintf(line, sizeof line, "%s  %s   %.0f mm at %.0f\xc2\xb0", target.id.c_str(), target.name.c_str(), 1e3 * target.depth, kDegrees * target.angle);
  const float w = pen.width(line, 17) + 32.0f, x = std::max(0.5f * (size.width - w), 396.0f);   // pixels
  pen.panel(x, size.height - 104.0f, w, 32);
  pen.text(x + 16, size.height - 98.0f, kText, line, 17);
}

void drawGlassFrame(const Pen& pen, const HudSize& size, const NeedlingView& n) {
  const Glass g = magnifier(static_cast<int>(size.width), static_cast<int>(size.height));        // pixels of a 720-line picture
  const float x = static_cast<float>(g.x), y = static_cast<float>(g.y), w = static_cast<float>(g.width), h = static_cast<float>(g.height);   // pixels
  pen.list->AddRect(pen.at(x, y), pen.at(x + w, y + h), kDim, 0.0f, 0, 1.5f * pen.scale);
  pen.panel(x, y + h - 26.0f, w, 26.0f);
  const float millimetre = h / static_cast<float>(1e3 * kGlassHeight);              // pixels
  pen.list->AddLine(pen.at(x + 10, y + h - 10), pen.at(x + 10 + millimetre, y + h - 10), kText, 2.0f * pen.scale);
  pen.text(x + 14 + millimetre, y + h - 19, kText, "1 mm", 12);
  char line[48];
  std::snprintf(line, sizeof line, "skin dented %.2f mm", 1e3 * n.dimple[0]);
  pen.text(x + w - 8 - pen.width(line, 12), y + h - 19, kText, line, 12);
}

}  // namespace

void drawNeedling(const Pen& pen, const HudSize& size, const LayeredBody& body, const RenderSnapshot& snapshot, const CameraView& camera) {
  const AcupointMark* target = targetOf(body);
  drawNames(pen, size, body, camera);
  drawReadings(pen, size, target, snapshot);
  drawGauge(pen, size, target, snapshot.needling);
  if (target) drawTarget(pen, size, *target);
  if (magnified(snapshot)) drawGlassFrame(pen, size, snapshot.needling);
}

}  // namespace halsted::render
