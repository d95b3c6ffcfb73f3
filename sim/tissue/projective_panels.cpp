#include <algorithm>
#include <span>

#include "sim/tissue/projective_model.h"

namespace halsted {
namespace {

std::span<const int> rowsOf(const FactorColumns& f, int column) {
  return {f.row.data() + f.start[column], static_cast<std::size_t>(f.start[column + 1] - f.start[column])};
}

/// A column ends in the same rows as the one before it, which itself comes on top of them.
bool continues(const FactorColumns& f, int column) {
  const auto before = rowsOf(f, column - 1), own = rowsOf(f, column);
  return before.size() == own.size() + 1 && before[0] == column && std::equal(own.begin(), own.end(), before.begin() + 1);
}

void addPanel(const FactorColumns& f, int first, int width, ProjectiveModel& p) {
  const auto below = rowsOf(f, first + width - 1);
  const int rows = width + static_cast<int>(below.size());
  const ProjectiveModel::Panel panel{first, width, rows, static_cast<int>(p.row.size()), static_cast<int>(p.value.size()), 0};
  for (int c = 0; c < width; ++c) p.row.push_back(4 * (first + c));
  for (int r : below) p.row.push_back(4 * r);
  p.value.resize(p.value.size() + static_cast<std::size_t>(rows * width), 0.0);
  for (int c = 0; c < width; ++c)
    for (int r = c + 1; r < rows; ++r) p.value[panel.value + r * width + c] = f.value[f.start[first + c] + r - c - 1];
  p.panels.push_back(panel);
}

/// Which part of the tissue each panel belongs to: a tree of the elimination forest (Liu 1990), in which a column hangs on the first of its
/// rows. The largest come first; each particle that is held is one by itself.
void nameParts(const FactorColumns& f, ProjectiveModel& p) {
  const int n = static_cast<int>(f.start.size()) - 1;
  std::vector<int> root(n), size(n, 0), roots, part(n);
  for (int j = n - 1; j >= 0; --j) {
    const auto rows = rowsOf(f, j);
    root[j] = rows.empty() ? j : root[rows[0]];
    if (rows.empty()) roots.push_back(j);
    ++size[root[j]];
  }
  std::stable_sort(roots.begin(), roots.end(), [&](int a, int b) { return size[a] > size[b]; });
  for (std::size_t k = 0; k < roots.size(); ++k) part[roots[k]] = std::min(static_cast<int>(k), ProjectiveModel::kMostParts - 1);
  for (ProjectiveModel::Panel& panel : p.panels) panel.part = part[root[panel.first]];
}

}  // namespace

void layOutFactor(const FactorColumns& f, ProjectiveModel& p) {
  const int n = static_cast<int>(f.start.size()) - 1;
  for (int first = 0; first < n;) {
    int width = 1;
    while (width < kPanelColumns && first + width < n && continues(f, first + width)) ++width;
    addPanel(f, first, width, p);
    first += width;
  }
  nameParts(f, p);
}

}  // namespace halsted
