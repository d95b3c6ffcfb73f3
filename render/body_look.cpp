#include "render/body_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "render/noise.h"

namespace halsted::render {
namespace {

struct Seed { double x, y; };                            // [1] cells
struct Nearest { double first = 9.0, second = 9.0; };    // [1] distances to the two nearest seeds

/// Worley 1996, on a torus of `cells` cells a side.
class Cells {
 public:
  Cells(int cells, std::uint32_t seed) : cells_(cells) {
    for (int i = 0; i < cells * cells; ++i) {
      const double u = nextRandom(seed), v = nextRandom(seed);       // [1]
      seeds_.push_back({0.1 + 0.8 * u, 0.1 + 0.8 * v});
    }
  }
  Nearest at(double x, double y) const {                 // [1] cells
    Nearest found;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di) {
        const Seed& s = seeds_[static_cast<std::size_t>(wrap(j + dj) * cells_ + wrap(i + di))];
        const double dx = i + di + s.x - x, dy = j + dj + s.y - y, d = std::sqrt(dx * dx + dy * dy);   // [1]
        if (d < found.first) found = {d, found.first};
        else found.second = std::min(found.second, d);
      }
    return found;
  }

 private:
  int wrap(int i) const { return (i % cells_ + cells_) % cells_; }
  int cells_;
  std::vector<Seed> seeds_;
};

}  // namespace

Image makeBodyImage(int size) {
  const Cells fine(34, 5), coarse(15, 9), lobules(9, 3), bundles(7, 7);
  NoiseWalk warps(2, 6), mottles(4, 4), grains(3, 32), fibres(3, 4), waves(2, 5);
  return bake(size, [&](int x, int y) -> std::array<double, 4> {
    const double u = static_cast<double>(x) / size, v = static_cast<double>(y) / size;   // [1]
    const double warp = warps.at(6 * u, 6 * v, 3.0) - 0.5, wave = waves.at(5 * u, 5 * v, 8.0) - 0.5;   // [1]
    const Nearest small = fine.at(34 * u + warp, 34 * v - warp), big = coarse.at(15 * u + warp, 15 * v + wave);
    const double furrow = smoothStep(0.02, 0.30, small.second - small.first) * (0.55 + 0.45 * smoothStep(0.0, 0.16, big.second - big.first));
    const double grain = grains.at(32 * u, 32 * v, 1.0);                                 // [1]
    const Nearest lobe = lobules.at(9 * u + warp, 9 * v + wave), bundle = bundles.at(7 * u, 7 * v + 0.8 * wave);
    const double globule = smoothStep(0.02, 0.22, lobe.second - lobe.first) * (1.0 - 0.45 * lobe.first);
    const double fibre = 0.7 * fibres.at(4 * u, 96 * v + 5 * wave, 2.0) + 0.3 * smoothStep(0.0, 0.25, bundle.second - bundle.first);
    return {0.86 * furrow + 0.14 * grain, globule, fibre, smoothStep(0.2, 0.8, mottles.at(4 * u, 4 * v, 0.0))};
  });
}

const char* const kWithShadow = "#define LIT shadowed(uShadow, vShadow)\n";
const char* const kWithoutShadow = "#define LIT 1.0\n";

const char* const kSkinFragment = R"(
in vec3 vPosition, vNormal, vShadow;
in vec2 vUv;
in vec4 vColor;
uniform sampler2D uSurface;
uniform sampler2DShadow uShadow;
uniform vec3 uEye;
out vec4 color;
void main() {
  vec4 detail = texture(uSurface, vUv);
  vec3 n = normalize(vNormal), v = normalize(uEye - vPosition);
  vec3 rough = bumped(n, vPosition, detail.r * 0.00005, 1.0);
  vec3 albedo = vColor.rgb * vColor.rgb * (0.90 + 0.16 * detail.a) * (0.91 + 0.11 * detail.r);
  vec3 wrap = vec3(0.34, 0.17, 0.12);                       // red light scatters furthest in skin
  vec3 direct = wrapped(dot(mix(n, rough, 0.75), kLamp), wrap);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec3 c = albedo * (1.02 * direct + mix(vec3(0.13, 0.10, 0.10), vec3(0.27, 0.28, 0.30), 0.5 + 0.5 * n.z) + 0.14 * facing * facing);
  // Sebum: a dull sheen that the furrows break up.
  float s = clamp(dot(rough, normalize(v + kLamp)), 0.0, 1.0);
  s *= s; s *= s; s *= s; float dull = s * s;               // power 16
  float edge = 1.0 - facing; edge *= edge; edge *= edge;
  c += (0.085 * dull * s + 0.045 * dull) * (0.4 + 0.6 * detail.r) + 0.05 * edge;
  color = vec4(sqrt(c) * LIT, 1.0);
})";

const char* const kSectionFragment = R"(
in vec3 vPosition, vNormal, vShadow;
in vec2 vUv;
in vec4 vColor;
uniform sampler2D uSurface;
uniform sampler2DShadow uShadow;
uniform vec3 uEye;
out vec4 color;
void main() {
  vec4 detail = texture(uSurface, vUv);
  vec3 n = normalize(vNormal), v = normalize(uEye - vPosition);
  float fat = step(vColor.a, 0.2), dermis = step(0.8, vColor.a), fascia = step(0.2, vColor.a) * step(vColor.a, 0.5);
  float fibre = detail.b;
  vec3 yellow = mix(vec3(0.74, 0.46, 0.26), vec3(0.86, 0.60, 0.17), smoothstep(0.05, 0.35, detail.g)) * (0.70 + 0.45 * detail.g);
  vec3 red = mix(vec3(0.25, 0.022, 0.020), vec3(0.50, 0.085, 0.065), fibre);
  red = mix(red, vec3(0.66, 0.36, 0.30), 0.55 * smoothstep(0.66, 0.86, fibre));     // perimysium between the bundles
  vec3 veil = mix(red, vec3(0.62, 0.42, 0.40), 0.55);
  vec3 pale = vec3(0.80, 0.53, 0.43) * (0.88 + 0.18 * detail.a);
  vec3 base = mix(red, veil, fascia);
  base = mix(base, yellow, fat);
  base = mix(base, pale, dermis);
  n = bumped(n, vPosition, fat * detail.g * 0.00045 + (1.0 - fat) * (1.0 - dermis) * fibre * 0.00022, 1.0);
  vec3 wrap = vec3(0.35, 0.20, 0.15);
  vec3 direct = wrapped(dot(n, kLamp), wrap);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec3 sky = vColor.rgb * vColor.rgb;
  vec3 c = base * sky * (0.95 * direct + vec3(0.26) + 0.20 * facing * facing);
  float s = clamp(dot(n, normalize(v + kLamp)), 0.0, 1.0);
  s *= s; s *= s; s *= s; s *= s; float wet = s * s;        // power 32
  c += (0.35 * wet * wet + 0.06 * wet) * (1.0 - 0.6 * dermis) * sky;
  color = vec4(sqrt(c) * shadowed(uShadow, vShadow), 1.0);
})";

const char* const kHandleFragment = R"(
in vec3 vPosition, vNormal, vShadow;
in vec2 vUv;
in float vPixels;
uniform sampler2D uReflection;
uniform vec3 uEye;
out vec4 color;
void main() {
  vec3 n = normalize(vNormal), v = normalize(uEye - vPosition);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec3 seen = mirrored(uReflection, n, v);
  float coil = 0.5 + 0.5 * sin(6.2831853 * (vUv.x * 1900.0 + vUv.y));
  float band = smoothstep(0.35, 0.6, sin(6.2831853 * (vUv.x * 330.0 + vUv.y)));   // one copper strand in a lay of 3 mm
  vec3 metal = mix(vec3(0.80, 0.81, 0.82), vec3(0.62, 0.26, 0.10), band);
  vec3 c = metal * (4.0 * seen + 0.14) * (0.45 + 0.55 * coil);
  color = vec4(sqrt(c), wireCover(facing, vPixels));
})";

const char* const kSheetFragment = R"(
in vec3 vPosition, vShadow;
in vec2 vUv;
uniform sampler2D uSurface;
uniform sampler2DShadow uShadow;
out vec4 color;
void main() {
  float fold = texture(uSurface, vUv * 0.21).a, away = length(vPosition.xy);
  vec3 c = vec3(0.26, 0.40, 0.42) * (0.80 + 0.35 * fold) * (0.012 + 0.988 * smoothstep(0.75, 0.10, away));
  color = vec4(sqrt(c) * shadowed(uShadow, vShadow), 1.0);
})";

const char* const kMarkFragment = R"(
in vec2 vCorner;
uniform float uOpen;                         // 1: the target's ring, 0: a dot
out vec4 color;
void main() {
  float d = length(vCorner);
  float ring = smoothstep(0.14, 0.05, abs(d - 0.82)) * uOpen, dot_ = smoothstep(0.26, 0.16, d) * (1.0 - 0.45 * uOpen);
  color = vec4(0.30, 0.16, 0.52, 0.78 * max(ring, dot_));
})";

}  // namespace halsted::render
