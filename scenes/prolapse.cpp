#include "scenes/prolapse.h"

#include <algorithm>
#include <cmath>

#include "scenes/input_text.h"
#include "scenes/scene.h"
#include "scenes/tube_grid.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

constexpr double kTipShare = 0.6;              // [1] of the length lies in front of the origin: the middle of what the hands reach
constexpr double kLeastLumen = 3e-3;           // [m] radius within the inner wall
constexpr int kFoldCells = 4;                  // round the fold, 45 degrees each

/// A point of the swept section and the direction through the wall there, from the mucosa to the serosa.
struct SectionPoint { double r = 0.0, z = 0.0, inR = 0.0, inZ = 0.0; };   // [m], [1]

/// Cells of the cuttable band: an odd number, the line runs through the middle of one.
int bandCells(const AnatomyParams& a) { return 2 * static_cast<int>(std::floor(a.cutBand / kCutRow)) + 1; }

double middleOfFold(const AnatomyParams& a) { return 0.5 * (a.gap + a.wall); }   // [m] radius of the fold's half circle, mid wall

SectionPoint mucosaAt(const AnatomyParams& a, const ProlapseProfile& p, double along) {   // [m]
  const double base = (kTipShare - 1.0) * a.length;                          // [m]
  const double outside = a.radius, inside = a.radius - 2.0 * a.wall - a.gap;   // [m] radii of both mucosae
  if (along <= p.straight) return {inside, base + along, 1.0, 0.0};
  if (along >= p.whole - p.straight) return {outside, base + p.whole - along, -1.0, 0.0};
  const double turn = kPi * (along - p.straight) / (p.whole - 2.0 * p.straight);   // [rad] 0 on the inner wall, pi on the outer
  const double r = 0.5 * a.gap + a.wall, towardR = -cosine(turn), towardZ = sine(turn);   // [m], [1] out of the fold
  return {0.5 * (outside + inside) + r * towardR, base + p.straight + r * towardZ, -towardR, -towardZ};
}

/// Rows of one wall, from its base to the beginning of the fold; the line lies in the middle of a row of cells.
std::vector<double> rowsOfWall(const AnatomyParams& a, double straight, int below, int above) {   // [m]
  const int cells = bandCells(a);
  const double from = a.cutHeight - 0.5 * cells * kCutRow, to = from + cells * kCutRow;   // [m]
  std::vector<double> rows;                    // [m]
  for (int i = 0; i < below; ++i) rows.push_back(from * i / below);
  for (int i = 0; i < cells; ++i) rows.push_back(from + kCutRow * i);
  for (int i = 0; i <= above; ++i) rows.push_back(to + (straight - to) * i / above);
  return rows;
}

double middleRadius(const AnatomyParams& a) { return a.radius - a.wall - 0.5 * a.gap; }   // [m] between both walls

TubeGrid sweep(const AnatomyParams& a, const ProlapseProfile& p, const std::vector<double>& section, TetMesh& mesh) {   // [1]
  TubeGrid grid;
  grid.around = a.around;
  grid.along = static_cast<int>(p.along.size());
  for (int row = 0; row < grid.along; ++row) {
    const SectionPoint at = mucosaAt(a, p, p.along[row]);
    for (int column = 0; column < grid.around; ++column) {
      const double angle = 2.0 * kPi * column / grid.around;                 // [rad]
      for (const double deep : {0.0, a.wall}) {                              // [m]
        const double r = at.r + deep * at.inR + (section[column] - 1.0) * middleRadius(a);   // [m]
        mesh.vertices.emplace_back(r * cosine(angle), r * sine(angle), at.z + deep * at.inZ);
        mesh.uv.emplace_back(static_cast<double>(column) / grid.around, p.fromLine[row]);
        mesh.bowel.push_back(row < p.firstOuterRow ? 1 : 0);
      }
    }
  }
  return grid;
}

/// Mucosa and serosa are named as the layers of any bowel: 1 and 0.
void nameLayers(TetMesh& mesh) {
  mesh.surface = boundaryTriangles(mesh.tets);
  for (const auto& triangle : mesh.surface) {
    int serosa = 0;
    for (int v : triangle) serosa += v & 1;
    mesh.triangleLayer.push_back(serosa == 0 ? 1 : serosa == 3 ? 0 : 2);
  }
}

/// Six tets a cell, in the order of the grid: row, column.
void markCuttable(const ProlapseProfile& p, const TubeGrid& grid, double halfBand, TetMesh& mesh) {   // [m]
  mesh.cuttable.assign(mesh.tets.size(), 0);
  mesh.cutLine.assign(mesh.tets.size(), {});
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const int cell = static_cast<int>(t) / kTetsPerCell, row = cell / grid.around, column = cell % grid.around;
    const double middle = 0.5 * (p.fromLine[row] + p.fromLine[row + 1]);     // [m]
    if (std::fabs(middle) > halfBand) continue;
    mesh.cuttable[t] = 1;
    mesh.cutLine[t] = {row < p.firstOuterRow ? 1 : 0, column, -middle};
  }
}

}  // namespace

double foldHeight(const AnatomyParams& a) { return 0.5 * a.gap + a.wall; }

ProlapseProfile prolapseProfile(const AnatomyParams& a) {
  ProlapseProfile p;
  p.straight = a.length - foldHeight(a);
  p.whole = 2.0 * p.straight + kPi * middleOfFold(a);
  const int band = bandCells(a);
  const double below = a.cutHeight - 0.5 * band * kCutRow, above = p.straight - a.cutHeight - 0.5 * band * kCutRow;   // [m] of coarse wall
  const int coarse = std::max(2, (a.along - 1 - kFoldCells - 2 * band) / 2);                    // cells of one wall
  const int low = std::clamp(static_cast<int>(std::floor(coarse * below / (below + above) + 0.5)), 1, coarse - 1);
  p.along = rowsOfWall(a, p.straight, low, coarse - low);
  const int wallRows = static_cast<int>(p.along.size());
  for (int i = 1; i < kFoldCells; ++i) p.along.push_back(p.straight + (p.whole - 2.0 * p.straight) * i / kFoldCells);
  for (int i = wallRows - 1; i >= 0; --i) p.along.push_back(p.whole - p.along[i]);
  p.firstOuterRow = wallRows + kFoldCells / 2;
  for (double s : p.along) p.fromLine.push_back(a.cutHeight - std::fmin(s, p.whole - s));
  const int line = low + band / 2;             // the inner line runs through the cells behind this row
  p.lineRow = {static_cast<int>(p.along.size()) - 1 - line, line};
  return p;
}

TetMesh prolapse(const AnatomyParams& params) { return prolapse(params, std::vector<double>(params.around, 1.0)); }

TetMesh prolapse(const AnatomyParams& params, const std::vector<double>& section) {   // [1]
  const double narrowest = *std::min_element(section.begin(), section.end());
  if (narrowest * middleRadius(params) - 0.5 * params.gap - params.wall < kLeastLumen)
    throw InputError("the real bowel's section is too flat for two walls in it: at its narrowest " + plainNumber(narrowest) + " of its mean radius");
  const ProlapseProfile profile = prolapseProfile(params);
  TetMesh mesh;
  const TubeGrid grid = sweep(params, profile, section, mesh);
  addWallTets(grid, mesh);
  nameLayers(mesh);
  markCuttable(profile, grid, 0.5 * bandCells(params) * kCutRow, mesh);
  for (const int wall : {0, 1})                // rims lie on the serosa, as a bowel's outer edge does
    for (int column = 0; column < grid.around; ++column) mesh.rim.push_back(wallVertex(grid, profile.lineRow[wall], column, 1));
  for (const int row : {0, grid.along - 1})
    for (int column = 0; column < grid.around; ++column)
      for (const int layer : {0, 1}) mesh.fixed.push_back(wallVertex(grid, row, column, layer));
  return mesh;
}

std::vector<double> crossSection(const TetMesh& tube, const AnatomyParams& a) {   // [1]
  TubeGrid grid;
  grid.around = a.around;
  std::vector<double> section(a.around, 0.0);  // [1]
  const int rows = static_cast<int>(tube.vertices.size()) / (2 * a.around);
  for (int row = 0; row < rows; ++row) {
    Vec3 middle = Vec3::Zero();                // [m]
    double mean = 0.0;                         // [m]
    for (int c = 0; c < a.around; ++c) middle += tube.vertices[wallVertex(grid, row, c, 0)] / a.around;
    for (int c = 0; c < a.around; ++c) mean += (tube.vertices[wallVertex(grid, row, c, 0)] - middle).norm() / a.around;
    for (int c = 0; c < a.around; ++c) section[c] += (tube.vertices[wallVertex(grid, row, c, 0)] - middle).norm() / (mean * rows);
  }
  return section;
}

}  // namespace halsted::scenes
