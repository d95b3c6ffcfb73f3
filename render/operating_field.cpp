#include "render/operating_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/color.h"
#include "render/light.h"
#include "render/noise.h"

namespace halsted::render {
namespace {

/// What is found at a point of the field, before light.
struct Ground {
  double height = 0.0;                       // [m] over the skin's plane
  Vec3 color = Vec3::Zero();                 // linear reflectance [1]
  double shade = 1.0;                        // [1] how much sky reaches it
  double kind = 0.0;                         // 0 drape, 0.5 pad, 1 wound
};

/// The noises of the field, each with its own walk along the rows of the picture.
struct PadNoises { NoiseWalk warp{3}, crease{3}, blood{4}; };
struct Noises {
  NoiseWalk warp{2}, crumple{3}, lobes{3}, red{3};
  std::array<PadNoises, 3> pads;
};

double cubed(double x) { return x * x * x; }                                                  // [1]
double squared(double x) { return x * x; }                                                    // [1]
double length(double x, double y) { return std::sqrt(x * x + y * y); }                        // [1] std::hypot's care costs too much here

/// Parabolas through the zeros and peaks of the sine: what a thread too fine for the picture needs, at a tenth of its cost.
double ripple(double x) {                                                                     // [rad] -> [1]
  const double turns = x / (2.0 * std::numbers::pi), t = 2.0 * (turns - std::floor(turns)) - 1.0;   // [1]
  return 4.0 * t * (std::abs(t) - 1.0);
}

Ground drapeAt(double x, double y, Noises& noises) {                                          // [1] organ radii
  const double warp = noises.warp.at(0.25 * x + 3.0, 0.25 * y, 1.0);                          // [1]
  const double along = 0.8 * x + 0.6 * y;                                                     // [1]
  const double fold = cubed(0.5 + 0.5 * std::sin(1.5 * along + 7.0 * warp));                    // [1]
  const double cross = squared(squared(0.5 + 0.5 * std::sin(0.9 * (y - 0.4 * x) + 6.0 * warp + 1.0)));   // [1]
  const double crumple = noises.crumple.at(1.4 * x, 1.4 * y, 4.0);                             // [1]
  Ground g;
  g.height = 6.5e-3 * fold + 4.5e-3 * cross + 1.6e-3 * crumple;
  const double weave = 0.5 + 0.5 * ripple(110.0 * x) * ripple(110.0 * y);                  // [1]
  g.shade = (0.55 + 0.45 * smoothStep(0.0, 0.7, fold + 0.7 * cross)) * (0.90 + 0.14 * weave);
  g.color = Vec3(0.030, 0.150, 0.185) * (0.9 + 0.25 * crumple);
  return g;
}

/// Gauze: two families of soft threads, bright where they cross.
double gauze(double u, double v) {                                                            // [1] threads
  const double a = 0.5 + 0.5 * ripple(u), b = 0.5 + 0.5 * ripple(v);                       // [1]
  return 0.76 + 0.12 * (a + b) + 0.10 * a * b;
}

/// Where and how a pad lies: place and half size in organ radii, cosine and sine of its turn.
struct Pad { double x, y, halfWidth, halfHeight, c, s, seed; };                               // [1]

const std::array<Pad, 3> kPads{{{-1.75, -0.35, 1.25, 2.1, std::cos(0.30), std::sin(0.30), 1.0},
                                {1.55, 0.55, 1.35, 1.9, std::cos(-0.20), std::sin(-0.20), 4.0},
                                {0.15, -1.9, 0.95, 1.9, std::cos(1.42), std::sin(1.42), 8.0}}};

/// Signed distance to a pad's rounded rectangle; negative inside. All in organ radii.
double padDistance(double x, double y, const Pad& pad) {                                      // [1]
  const double u = std::abs(pad.c * (x - pad.x) + pad.s * (y - pad.y)) - pad.halfWidth;       // [1]
  const double v = std::abs(-pad.s * (x - pad.x) + pad.c * (y - pad.y)) - pad.halfHeight;     // [1]
  return length(std::max(u, 0.0), std::max(v, 0.0)) + std::min(std::max(u, v), 0.0) - 0.35;
}

void layPad(double x, double y, const Pad& pad, PadNoises& noises, Ground& g) {               // [1] organ radii
  const double d = padDistance(x, y, pad), seed = pad.seed;                                   // [1]
  if (d > 0.5) return;
  const double warp = noises.warp.at(0.7 * x + seed, 0.7 * y, 2.0 + seed);                    // [1]
  const double inside = smoothStep(0.02, -0.05, d + 0.10 * (warp - 0.5));                     // [1]
  if (inside <= 0.0) {
    g.shade *= 0.40 + 0.60 * smoothStep(-0.05, 0.40, d);                                      // contact shadow on what lies below
    return;
  }
  const double fold = squared(0.5 + 0.5 * std::sin(2.6 * (0.5 * x - y) + 8.0 * warp + seed));   // [1]
  const double crease = noises.crease.at(2.2 * x + seed, 2.2 * y, 9.0 + seed);                 // [1]
  const double soak = smoothStep(2.4, 1.2, length(x, y) + 1.3 * (warp - 0.5));            // [1] fluid near the wound
  const double blood = smoothStep(0.60, 0.72, noises.blood.at(0.9 * x + 2 * seed, 0.9 * y, 6.0)) * smoothStep(3.0, 1.4, length(x, y));   // [1]
  Vec3 color = Vec3(0.80, 0.79, 0.75) * (1.0 - 0.22 * soak);
  color = color.cwiseProduct(Vec3(1.0, 1.0 - 0.42 * soak - 0.52 * blood, 1.0 - 0.46 * soak - 0.52 * blood).cwiseMax(Vec3::Constant(0.06)));
  const double hem = smoothStep(0.030, 0.012, std::abs(d + 0.30)) * smoothStep(-0.4, 0.3, std::sin(34.0 * (x + 1.3 * y)));   // [1]
  color = mixed(color, Vec3(0.05, 0.13, 0.42), hem);                                 // stitches of the marker thread
  const double roll = smoothStep(-0.22, 0.0, d);                                              // [1] the hem curls down
  g.height = (1.0 - inside) * g.height + inside * (6.5e-3 + 3.0e-3 * fold + 2.2e-3 * crease - 3.0e-3 * roll * roll);
  g.color = mixed(g.color, color, inside);
  g.shade = (1.0 - inside) * g.shade + inside * (0.60 + 0.40 * fold) * gauze(150.0 * x + 9.0 * warp, 150.0 * y + 9.0 * crease);
  g.kind = inside > 0.5 ? 0.5 : g.kind;
}

void openWound(double x, double y, Noises& noises, Ground& g) {                               // [1] organ radii
  const double r = length(x, y);                                                               // [1]
  if (r > 2.0) return;
  const double a = std::atan2(y, x);                                                           // [rad]
  const double edge = 1.42 + 0.16 * noise(1.3 * std::cos(a) + 5.0, 1.3 * std::sin(a), 3.0) + 0.05 * std::sin(5.0 * a);   // [1]
  const double inside = smoothStep(edge + 0.02, edge - 0.05, r);                               // [1]
  if (inside <= 0.0) {
    g.shade *= 0.55 + 0.45 * smoothStep(edge, edge + 0.2, r);
    return;
  }
  const double lobes = std::sqrt(std::abs(std::sin(14.0 * noises.lobes.at(2.4 * x, 2.4 * y, 7.0))));   // [1]
  const double deep = smoothStep(edge, 0.95, r);                                              // [1]
  const double red = smoothStep(0.35, 0.65, noises.red.at(1.2 * x, 1.2 * y, 11.0));          // [1]
  Vec3 color = mixed(Vec3(0.72, 0.47, 0.15), Vec3(0.44, 0.070, 0.055), red);          // fat and raw muscle
  color = mixed(color, Vec3(0.22, 0.02, 0.018), 0.6 * deep);
  g.height = (1.0 - inside) * g.height + inside * (2e-3 - 10e-3 * deep + 1.3e-3 * lobes);
  g.color = mixed(g.color, color, inside);
  g.shade = (1.0 - inside) * g.shade + inside * (0.95 - 0.78 * deep) * (0.35 + 0.65 * lobes) * smoothStep(0.82, 1.0, r);
  g.kind = inside > 0.5 ? 1.0 : g.kind;
}

/// Skin in the window of the drapes: creases run toward the anus and it is darker there; a low mound where the bowel comes out.
void perianalSkin(double x, double y, Noises& noises, Ground& g) {                            // [1] organ radii
  const double r = length(x, y);                                                               // [1]
  if (r > 3.6) return;
  const double a = std::atan2(y, x), c = std::cos(a), s = std::sin(a);                         // [rad] [1]
  const double warp = noise(1.1 * x + 9.0, 1.1 * y, 5.0);                                      // [1]
  const double inside = smoothStep(3.30, 3.18, r + 0.25 * noise(0.8 * c + 5.0, 0.8 * s, 3.0));   // [1] the drape's edge
  if (inside <= 0.0) return;
  const double near = smoothStep(2.2, 1.05, r + 0.3 * (warp - 0.5));                           // [1]
  const double crease = squared(0.5 + 0.5 * std::sin(34.0 * a + 5.0 * noise(3.0 * c, 3.0 * s, 1.5 * r))) * smoothStep(2.0, 1.1, r) * smoothStep(0.92, 1.0, r);   // [1]
  const double grain = noises.lobes.at(9.0 * x, 9.0 * y, 2.0), red = noises.red.at(1.2 * x, 1.2 * y, 11.0);   // [1]
  Vec3 color = mixed(Vec3(0.56, 0.33, 0.24), Vec3(0.60, 0.28, 0.21), smoothStep(0.35, 0.65, red));
  color = mixed(color, Vec3(0.30, 0.135, 0.095), 0.75 * near);                                 // pigmented
  color = mixed(color, Vec3(0.46, 0.13, 0.10), 0.6 * smoothStep(1.22, 1.04, r));               // anoderm
  const double edge = smoothStep(3.02, 3.18, r);                                               // [1] below the drape's thick edge
  g.height = (1.0 - inside) * g.height + inside * (3.2e-3 * near - 0.9e-3 * crease + 0.35e-3 * grain);
  g.color = mixed(g.color, color * (0.92 + 0.16 * grain), inside);
  g.shade = (1.0 - inside) * g.shade + inside * (1.0 - 0.35 * crease) * (1.0 - 0.45 * edge) * (0.55 + 0.45 * smoothStep(0.98, 1.5, r));
  const double below = smoothStep(1.0, 0.92, r), lumen = smoothStep(0.66, 0.60, r);            // [1] between the walls, and in the inner one
  g.color = mixed(g.color, Vec3(0.26, 0.035, 0.03), below);
  g.shade *= (1.0 - 0.65 * below) * (1.0 - 0.9 * lumen);
  g.kind = inside > 0.5 ? 0.25 : g.kind;
}

Ground groundAt(double x, double y, bool perineum, Noises& noises) {                          // [1] organ radii
  Ground g = drapeAt(x, y, noises);
  if (perineum) {
    perianalSkin(x, y, noises, g);
    return g;
  }
  for (std::size_t i = 0; i < kPads.size(); ++i) layPad(x, y, kPads[i], noises.pads[i], g);
  openWound(x, y, noises, g);
  return g;
}

/// The lamp's pool of light ends softly: the theatre around the table is dark.
double pool(double x, double y) { return 0.16 + 0.84 * smoothStep(7.0, 1.2, length(x, y)); }   // [1] organ radii

constexpr double kCell = 2.0 * kFieldHalfSize / kFieldCells;                                  // [m]

void addCell(int i, int j, std::vector<std::uint32_t>& indices) {
  const auto at = [&](int di, int dj) { return static_cast<std::uint32_t>((j + dj) * (kFieldCells + 1) + i + di); };
  indices.insert(indices.end(), {at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1)});
}

/// Cells inside the organ are left out: its lumen goes on below the skin. A prolapse that has been cut off is looked into between its
/// walls, which the ground's cells are too coarse to follow: there the ground is painted.
bool underOrgan(int i, int j, const FieldPlace& place) {
  if (place.perineum) return false;
  const double x = (i + 0.5) * kCell - kFieldHalfSize, y = (j + 0.5) * kCell - kFieldHalfSize;   // [m]
  return length(x, y) + 0.5 * kCell < 0.85 * place.radius;
}

Shape makeGrid(const FieldPlace& place) {
  Shape shape;
  Noises noises;
  for (int j = 0; j <= kFieldCells; ++j)
    for (int i = 0; i <= kFieldCells; ++i) {
      const double x = i * kCell - kFieldHalfSize, y = j * kCell - kFieldHalfSize;             // [m]
      ShapeVertex vertex{};
      const double z = place.centre.z() + groundAt(x / place.radius, y / place.radius, place.perineum, noises).height;  // [m]
      const double position[3] = {place.centre.x() + x, place.centre.y() + y, z};               // [m]
      for (int k = 0; k < 3; ++k) vertex.position[k] = static_cast<float>(position[k]);
      vertex.normal[2] = 1.0f;
      vertex.uv[0] = static_cast<float>(static_cast<double>(i) / kFieldCells);
      vertex.uv[1] = static_cast<float>(static_cast<double>(j) / kFieldCells);
      shape.vertices.push_back(vertex);
    }
  for (int j = 0; j < kFieldCells; ++j)
    for (int i = 0; i < kFieldCells; ++i)
      if (!underOrgan(i, j, place)) addCell(i, j, shape.indices);
  return shape;
}

/// One texel: light on what is found there, whose slope the neighbours' heights tell.
struct Slope { double x, y, run; };                                                           // [m]

Vec3 litColor(const Ground& g, const Slope& slope) {                                          // linear [1]
  static const Vec3 lamp = lightDirection(), half = (lamp + Vec3::UnitZ()).normalized();
  const Vec3 n = Vec3(slope.x, slope.y, slope.run).normalized();
  const double light = g.shade * (0.30 + 1.05 * std::max(0.0, 0.15 + 0.85 * n.dot(lamp)));    // [1]
  const double glint = g.kind > 0.9 ? 0.5 * std::pow(std::max(0.0, n.dot(half)), 40.0) * g.shade : 0.0;   // [1] wet
  return g.color * light + Vec3::Constant(glint);
}

/// Three rows of ground are all that a row of the picture needs; the whole of it would take a hundred megabytes.
class FieldPainter {
 public:
  FieldPainter(const FieldPlace& place, int size) : radius_(place.radius), perineum_(place.perineum), size_(size), texel_(2.0 * kFieldHalfSize / size) {
    for (auto& row : rows_) row.resize(static_cast<std::size_t>(size));
    survey(0);
  }

  /// Rows in their order, from 0.
  void paint(int y, std::uint8_t* out) {
    if (y + 1 < size_) survey(y + 1);
    const std::vector<Ground>&before = row(std::max(y - 1, 0)), &own = row(y), &after = row(std::min(y + 1, size_ - 1));
    for (int x = 0; x < size_; ++x, out += 4) {
      const Slope slope{own[std::max(x - 1, 0)].height - own[std::min(x + 1, size_ - 1)].height, before[x].height - after[x].height, 2.0 * texel_};
      const Vec3 lit = litColor(own[x], slope) * pool(at(x), at(y));
      for (int k = 0; k < 3; ++k) out[k] = rootByteOf(lit[k]);
      out[3] = byteOf(own[x].kind);
    }
  }

 private:
  double at(int i) const { return ((i + 0.5) * texel_ - kFieldHalfSize) / radius_; }          // -> organ radii [1]
  std::vector<Ground>& row(int y) { return rows_[static_cast<std::size_t>(y % 3)]; }
  void survey(int y) {
    for (int x = 0; x < size_; ++x) row(y)[static_cast<std::size_t>(x)] = groundAt(at(x), at(y), perineum_, noises_);
  }

  double radius_;                                                                             // [m]
  bool perineum_;
  int size_;
  double texel_;                                                                              // [m]
  Noises noises_;
  std::array<std::vector<Ground>, 3> rows_;
};

}  // namespace

OperatingField makeOperatingField(const FieldPlace& place, int size) {
  OperatingField field{makeGrid(place), {size, size, std::vector<std::uint8_t>(4u * size * size)}};
  FieldPainter painter(place, size);
  for (int y = 0; y < size; ++y) painter.paint(y, &field.picture.rgba[4u * static_cast<std::size_t>(y) * size]);
  return field;
}

}  // namespace halsted::render
