#include "render/hud_drawing.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace halsted::render {
namespace {

constexpr ImU32 kText = IM_COL32(232, 240, 240, 255), kDim = IM_COL32(150, 172, 176, 255), kPanel = IM_COL32(6, 16, 20, 150);
constexpr ImU32 kGood = IM_COL32(104, 214, 160, 255), kWarn = IM_COL32(255, 190, 80, 255), kBad = IM_COL32(255, 96, 84, 255);
constexpr ImU32 kTrack = IM_COL32(255, 255, 255, 34);
const char* const kFontPath = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";   // Debian fonts-dejavu-core

/// A pen over the frame's draw list; sizes are in pixels of a 720-line picture.
struct Pen {
  ImDrawList* list;
  float scale;                                             // [1]

  ImVec2 at(float x, float y) const { return ImVec2(x * scale, y * scale); }
  void panel(float x, float y, float w, float h) const { list->AddRectFilled(at(x, y), at(x + w, y + h), kPanel, 5.0f * scale); }
  void bar(float x, float y, float w, float share, ImU32 color) const {
    list->AddRectFilled(at(x, y), at(x + w, y + 6), kTrack, 3.0f * scale);
    const float filled = w * std::clamp(share, 0.0f, 1.0f);                        // pixels
    if (filled > 1.0f) list->AddRectFilled(at(x, y), at(x + filled, y + 6), color, 3.0f * scale);
  }
  void text(float x, float y, ImU32 color, const char* words, float size = 15.0f, float wrap = 0.0f) const {
    list->AddText(ImGui::GetFont(), size * scale, at(x, y), color, words, nullptr, wrap * scale);
  }
  float width(const char* words, float size = 15.0f) const {                       // pixels of a 720-line picture
    return ImGui::GetFont()->CalcTextSizeA(size * scale, 1e9f, 0.0f, words).x / scale;
  }
  template <typename... Args>
  void print(float x, float y, ImU32 color, const char* format, Args... args) const {
    char line[256];
    std::snprintf(line, sizeof line, format, args...);
    text(x, y, color, line);
  }
};

ImU32 forceColor(double force) { return force > 3.0 ? kBad : force > 1.5 ? kWarn : kGood; }   // [N] devices give 3.3 N at most

}  // namespace

HudDrawing::HudDrawing(const RenderScene& scene, int width, int height)
    : width_(static_cast<float>(width)), height_(static_cast<float>(height)), scale_(static_cast<float>(height) / 720.0f),
      title_(scene.title.empty() ? scene.name : scene.title), ids_(scene.stepIds), instructions_(scene.instructions), tools_(scene.tools) {
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

void HudDrawing::draw(const RenderSnapshot& snapshot, const HudInput& hud) {
  ImGui::SetCurrentContext(context_);
  ImGui::GetIO().DeltaTime = 1.0f / 30.0f;                 // [s] nothing animates: the same input gives the same picture
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  const Pen pen{ImGui::GetBackgroundDrawList(), scale_};
  const float right = width_ / scale_, bottom = height_ / scale_;
  pen.panel(12, 12, 360, 60);
  pen.text(24, 18, kText, title_.c_str(), 17);
  pen.print(24, 42, kDim, "%.1f s", snapshot.time);
  (void)right; (void)bottom; (void)hud; (void)forceColor; (void)kGood;
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace halsted::render
