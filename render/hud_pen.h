#pragma once
/// Colours and strokes of the head-up display. Included by the .cpp files that draw it.
#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>

#include "render/hud_panels.h"

namespace halsted::render {

inline constexpr ImU32 kText = IM_COL32(232, 240, 240, 255), kDim = IM_COL32(150, 172, 176, 255);
inline constexpr ImU32 kGood = IM_COL32(104, 214, 160, 255), kWarn = IM_COL32(255, 190, 80, 255), kBad = IM_COL32(255, 96, 84, 255);
inline constexpr ImU32 kTrack = IM_COL32(255, 255, 255, 34);

/// A number under its name.
struct Reading { const char* name; ImU32 color; char value[32]; };
template <typename... Args>
Reading reading(const char* name, ImU32 color, const char* format, Args... args) {
  Reading out{name, color, {}};
  std::snprintf(out.value, sizeof out.value, format, args...);
  return out;
}

/// A pen over the frame's draw list; sizes are in pixels of a 720-line picture.
struct Pen {
  ImDrawList* list;
  HudPanels& panels;
  float scale;                                             // [1]

  ImVec2 at(float x, float y) const { return ImVec2(x * scale, y * scale); }   // [pixels]
  void panel(float x, float y, float w, float h) const { panels.add(x * scale, y * scale, w * scale, h * scale, 5.0f * scale); }   // [pixels]
  void bar(float x, float y, float w, float share, ImU32 color) const {   // [pixels]
    list->AddRectFilled(at(x, y), at(x + w, y + 6), kTrack, 3.0f * scale);
    const float filled = w * std::clamp(share, 0.0f, 1.0f);                        // pixels
    if (filled > 1.0f) list->AddRectFilled(at(x, y), at(x + filled, y + 6), color, 3.0f * scale);
  }
  void text(float x, float y, ImU32 color, const char* words, float size = 15.0f, float wrap = 0.0f) const {   // [pixels]
    list->AddText(ImGui::GetFont(), size * scale, at(x, y), color, words, nullptr, wrap * scale);
  }
  float width(const char* words, float size = 15.0f) const {                       // [pixels] of a 720-line picture
    return ImGui::GetFont()->CalcTextSizeA(size * scale, 1e9f, 0.0f, words).x / scale;
  }
  float height(const char* words, float size, float wrap) const {                  // [pixels] of a 720-line picture
    return ImGui::GetFont()->CalcTextSizeA(size * scale, 1e9f, wrap * scale, words).y / scale;
  }
  template <typename... Args>
  void print(float x, float y, ImU32 color, const char* format, Args... args) const {   // [pixels]
    char line[256];
    std::snprintf(line, sizeof line, format, args...);
    text(x, y, color, line);
  }
  /// On a panel of their own, `spacing` apart, side by side about the middle of its upper edge.
  template <std::size_t N>
  void readings(const ImVec2& middle, float spacing, float size, const Reading (&row)[N]) const {   // [pixels]
    const float x = middle.x - 0.5f * spacing * static_cast<float>(N), y = middle.y;   // pixels
    panel(x, y, spacing * static_cast<float>(N), 50.0f);
    for (std::size_t i = 0; i < N; ++i) {
      const float centre = x + spacing * (0.5f + static_cast<float>(i));               // pixels
      text(centre - 0.5f * width(row[i].name, 12), y + 5, kDim, row[i].name, 12);
      text(centre - 0.5f * width(row[i].value, size), y + 31 - 0.5f * size, row[i].color, row[i].value, size);
    }
  }
};

inline ImU32 forceColor(double force) { return force > 3.0 ? kBad : force > 1.5 ? kWarn : kGood; }   // [N] devices give 3.3 N at most

}  // namespace halsted::render
