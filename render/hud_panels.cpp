#include "render/hud_panels.h"

#include <array>
#include <cmath>
#include <numbers>

#include "render/program.h"

namespace halsted::render {
namespace {

constexpr std::size_t kMostPanels = 16;
constexpr int kPerCorner = 4;                  // points of a quarter circle
constexpr int kPoints = 4 * kPerCorner;
constexpr std::size_t kFloatsPerPanel = 2 * 3 * (kPoints - 2);

const char* const kVertex = R"(
layout(location = 0) in vec2 aPosition;
void main() { gl_Position = vec4(aPosition, 0.0, 1.0); })";

const char* const kFragment = R"(
out vec4 color;
void main() { color = vec4(0.0235, 0.0627, 0.0784, 0.588); })";

}  // namespace

HudPanels::HudPanels(int width, int height)
    : width_(static_cast<float>(width)), height_(static_cast<float>(height)), program_(programOf(kVertex, kFragment)), array_(makeArray()),
      buffer_(makeBuffer()) {
  corners_.reserve(kMostPanels * kFloatsPerPanel);
  glBindVertexArray(array_);
  describe(buffer_, 2 * sizeof(float), {{0, 2, 0}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(kMostPanels * kFloatsPerPanel * sizeof(float)), nullptr, GL_STREAM_DRAW);
}

void HudPanels::add(float x, float y, float w, float h, float radius) {
  if (corners_.size() + kFloatsPerPanel > kMostPanels * kFloatsPerPanel) return;
  std::array<std::array<float, 2>, kPoints> outline{};   // clip space [1]
  for (int i = 0; i < kPoints; ++i) {
    const int corner = i / kPerCorner;                   // counter-clockwise from the upper right one
    const bool right = corner == 0 || corner == 3, upper = corner < 2;
    const double turn = 0.5 * std::numbers::pi * (corner + static_cast<double>(i % kPerCorner) / (kPerCorner - 1));   // [rad]
    const float px = (right ? x + w - radius : x + radius) + radius * static_cast<float>(std::cos(turn));     // pixels
    const float py = (upper ? y + radius : y + h - radius) - radius * static_cast<float>(std::sin(turn));     // pixels
    outline[static_cast<std::size_t>(i)] = {2.0f * px / width_ - 1.0f, 1.0f - 2.0f * py / height_};
  }
  for (std::size_t i = 2; i < kPoints; ++i)
    for (const std::size_t k : {std::size_t{0}, i - 1, i}) corners_.insert(corners_.end(), outline[k].begin(), outline[k].end());
}

void HudPanels::draw() const {
  if (corners_.empty()) return;
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(corners_.size() * sizeof(float)), corners_.data());
  glUseProgram(program_.id);
  glDisable(GL_DEPTH_TEST);
  const Blending over(Blending::kOver);
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size() / 2));
  glEnable(GL_DEPTH_TEST);
}

}  // namespace halsted::render
