#pragma once
/// Pictures as a person last looked at them, in tests/golden.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "render/hud.h"
#include "render/png.h"

namespace halsted::render {

inline constexpr int kWidth = 320, kHeight = 180;   // of a picture that is kept

/// Share of colour values that differ by more than `tolerance`.
inline double difference(const Frame& a, const Frame& b, int tolerance) {
  if (a.rgba.size() != b.rgba.size()) return 1.0;
  std::size_t off = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) off += std::abs(a.rgba[i] - b.rgba[i]) > tolerance;
  return static_cast<double>(off) / static_cast<double>(a.rgba.size());
}

inline HudInput noHud() {
  HudInput hud;
  hud.visible = false;
  return hud;
}

/// A change of the picture on purpose: HALSTED_GOLDEN_WRITE=1, then look at the files before committing them.
inline void expectGolden(const Frame& frame, const std::string& name) {
  const std::string path = (std::filesystem::path(__FILE__).parent_path().parent_path() / "golden" / (name + ".png")).string();
  if (std::getenv("HALSTED_GOLDEN_WRITE")) writePng(path, frame);
  ASSERT_TRUE(std::filesystem::exists(path)) << path;
  const double off = difference(readPng(path), frame, 1);                        // [1]
  if (off > 0.005) writePng(name + "_now.png", frame);
  EXPECT_LE(off, 0.005) << name << "_now.png in the working folder shows the difference";
}

}  // namespace halsted::render
