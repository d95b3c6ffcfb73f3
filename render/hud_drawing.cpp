#include "render/hud_drawing.h"

#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "render/hud_needling.h"
#include "render/hud_pen.h"

namespace halsted::render {
namespace {

const char* const kFontPath = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";   // Debian fonts-dejavu-core

/// A dot a step: filled when done, ringed when current. A long procedure shows the stretch that ends with the current step.
void drawSteps(const Pen& pen, const std::vector<std::string>& ids, int current, float y) {
  constexpr float kFrom = 28, kTo = 384;                   // pixels
  const int steps = static_cast<int>(ids.size()), last = std::clamp(current, 0, std::max(0, steps - 1));
  const auto width = [&](int i) { return 22.0f + pen.width(ids[i].c_str(), 12); };   // pixels
  int first = steps > 0 ? last : 0;
  float room = kTo - kFrom - (steps > 0 ? width(last) : 0.0f);                       // pixels
  for (; first > 0 && width(first - 1) <= room; --first) room -= width(first - 1);
  float x = kFrom;                                         // pixels
  for (int i = first; i < steps && x + width(i) <= kTo; ++i) {
    const ImVec2 c = pen.at(x, y + 8);
    if (i < current) pen.list->AddCircleFilled(c, 4.0f * pen.scale, kGood, 12);
    else pen.list->AddCircle(c, 4.0f * pen.scale, i == current ? kText : kDim, 12, 1.4f * pen.scale);
    pen.text(x + 7, y, i == current ? kText : kDim, ids[i].c_str(), 12);
    x += width(i);
  }
}

/// Which stitch of how many, of a procedure that repeats.
struct Round { int done = 0, wanted = 0; };

void drawProcedure(const Pen& pen, const std::string& title, const std::vector<std::string>& ids,
                   const std::vector<std::string>& instructions, int current, const Round& round) {
  constexpr float kFrom = 60.0f, kSize = 13.0f, kWrap = 350.0f;        // pixels
  const int steps = static_cast<int>(ids.size());
  const bool told = current >= 0 && current < std::min(steps, static_cast<int>(instructions.size()));
  const float below = std::max(88.0f, told ? kFrom + pen.height(instructions[current].c_str(), kSize, kWrap) + 2.0f : 0.0f);   // pixels
  pen.panel(12, 12, 372, below - 14.0f + (steps ? 22.0f : 0.0f));
  pen.text(24, 18, kText, title.c_str(), 16);
  if (current >= 0 && current < steps) {
    pen.print(24, 41, kGood, "%d/%d  %s", current + 1, steps, ids[current].c_str());
    if (round.wanted > 0) pen.print(250, 41, kText, "stitches %d of %d", round.done, round.wanted);
    if (told) pen.text(24, kFrom, kText, instructions[current].c_str(), kSize, kWrap);
  } else if (steps) {
    pen.text(24, 41, kGood, "Procedure completed");
  }
  drawSteps(pen, ids, current, below);
}

const char* toolText(ToolKind tool) {
  switch (tool) {
    case ToolKind::kNeedleDriver: return "needle driver";
    case ToolKind::kForceps: return "forceps";
    case ToolKind::kAcupunctureNeedle: return "needle";
    case ToolKind::kFinger: return "finger";
    case ToolKind::kNone: return "empty";
    case ToolKind::kElectrocautery: return "electrocautery";
    case ToolKind::kAllis: return "Allis clamp";
  }
  return "";
}

void drawHand(const Pen& pen, float x, float y, const char* hand, ToolKind tool, double force, double jaw) {   // force [N], jaw [1]
  pen.panel(x, y, 216, 50);
  pen.print(x + 12, y + 6, kText, "%s  %s", hand, toolText(tool));
  char line[32];
  std::snprintf(line, sizeof line, "%.2f N", force);
  pen.text(x + 204 - pen.width(line), y + 6, forceColor(force), line);
  pen.bar(x + 12, y + 29, 192, static_cast<float>(force / 3.3), forceColor(force));
  pen.list->AddRectFilled(pen.at(x + 12, y + 39), pen.at(x + 12 + 192.0f * static_cast<float>(std::clamp(jaw, 0.0, 1.0)), y + 41), kDim);
}

void drawMeasures(const Pen& pen, float right, float y, const RenderSnapshot& s) {
  pen.readings({0.5f * right, y}, 100.0f, 18.0f,
               {reading("time", kText, "%.1f s", s.time), reading("thread", forceColor(0.6 * s.threadTension), "%.2f N", s.threadTension),
                reading("bites", kText, "%u", s.bites), reading("faults", s.faults ? kBad : kGood, "%u", s.faults),
                reading("opening", kText, "%.2f cm\xc2\xb2", 1e4 * s.openingArea)});
}

void drawTiming(const Pen& pen, float right, const HudInput& hud) {
  const float x = right - 252.0f;                          // pixels
  pen.panel(x, 12, 240, 64);
  pen.print(x + 12, 17, hud.stale ? kBad : kDim, "haptics  %.0f Hz  late %.0f us", hud.hapticRate, hud.hapticLateness);
  pen.print(x + 12, 36, hud.late ? kWarn : kDim, "physics  %.2f ms  late %llu", hud.physics.stepMilliseconds,
            static_cast<unsigned long long>(hud.physics.lateSteps));
  pen.print(x + 12, 55, kDim, "picture  %.0f / s", hud.framesPerSecond);
}

/// Between the panels of the procedure and of the timing; what is longer goes on in the next line.
void drawWarnings(const Pen& pen, float right, const HudInput& hud) {
  constexpr float kLeftEdge = 396.0f, kRightEdge = 264.0f, kMargin = 20.0f, kSize = 17.0f;   // pixels
  float y = 14;                                            // pixels
  const auto banner = [&](const char* words, ImU32 color) {
    const float room = right - kRightEdge - kLeftEdge;     // pixels
    const float w = std::min(pen.width(words, kSize) + 2.0f * kMargin, room), x = std::max(0.5f * (right - w), kLeftEdge);   // pixels
    const float wrap = room - 2.0f * kMargin, h = pen.height(words, kSize, wrap) + 15.0f;   // pixels
    pen.panel(x, y, w, h);
    pen.list->AddRectFilled(pen.at(x, y), pen.at(x + 5, y + h), color);
    pen.text(x + kMargin, y + 6, color, words, kSize, wrap);
    y += h + 6;
  };
  if (hud.stale) banner("Physics stalled: forces are faded out", kBad);
  if (hud.late) banner("Physics is late: the scene runs slower than the clock", kWarn);
  for (int hand = 0; hand < kHands; ++hand)
    if (hud.haptic.faultCode[hand]) banner(hand == kLeft ? "Left device: force switched off" : "Right device: force switched off", kBad);
  if (!hud.message.empty()) banner(hud.message.c_str(), kWarn);
}

}  // namespace

HudDrawing::HudDrawing(const RenderScene& scene, int width, int height)
    : width_(static_cast<float>(width)), height_(static_cast<float>(height)), scale_(static_cast<float>(height) / 720.0f),
      panels_(width, height),
      title_(scene.title.empty() ? scene.name : scene.title), body_(scene.body), ids_(scene.stepIds), instructions_(scene.instructions), tools_{scene.tools, scene.secondTools},
      stitchesWanted_(scene.stitchesWanted) {
  context_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;                                // no file is written behind the user's back
  io.LogFilename = nullptr;
  io.DisplaySize = ImVec2(width_, height_);
  const float pixels = std::max(15.0f * scale_, 8.0f);
  std::FILE* font = std::fopen(kFontPath, "rb");           // asked first: Dear ImGui asserts on a missing file
  if (font) {
    std::fclose(font);
    io.Fonts->AddFontFromFileTTF(kFontPath, pixels);
  } else {
    io.Fonts->AddFontDefault();                            // small, but always there
  }
  if (!ImGui_ImplOpenGL3_Init("#version 330")) throw std::runtime_error("Dear ImGui cannot use this OpenGL");
}

HudDrawing::~HudDrawing() {
  ImGui::SetCurrentContext(context_);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void HudDrawing::draw(const RenderSnapshot& snapshot, const HudInput& hud, const CameraView& camera) {
  ImGui::SetCurrentContext(context_);
  ImGui::GetIO().DeltaTime = 1.0f / 30.0f;                 // [s] nothing animates: the same input gives the same picture
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  panels_.clear();
  const Pen pen{ImGui::GetBackgroundDrawList(), panels_, scale_};
  const float right = width_ / scale_, bottom = height_ / scale_;   // pixels of a 720-line picture
  drawProcedure(pen, title_, ids_, instructions_, snapshot.procedureStep, {snapshot.stitchesDone, stitchesWanted_});
  for (int hand = 0; hand < kHands; ++hand) {
    const double force = (hud.live ? hud.haptic.force[hand] : snapshot.tools[hand].force).norm();   // [N]
    drawHand(pen, hand == kLeft ? 12.0f : right - 228.0f, bottom - 62.0f, hand == kLeft ? "Left" : "Right", tools_[snapshot.tools[hand].second ? 1 : 0][hand], force,
             snapshot.tools[hand].jaw);
  }
  if (body_.layers > 0) drawNeedling(pen, {right, bottom}, body_, snapshot, camera);
  else drawMeasures(pen, right, bottom - 62.0f, snapshot);
  if (hud.live) drawTiming(pen, right, hud);
  drawWarnings(pen, right, hud);
  panels_.draw();                                          // beneath the words
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace halsted::render
