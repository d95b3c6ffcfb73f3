#include <algorithm>
#include <set>
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

/// Elimination tree (Liu 1990): on the way back a column needs those of its rows, all of them above it.
struct Forest {
  std::vector<std::vector<int>> children;      // of each column
  std::vector<int> chain;                      // entries from the column down to its farthest leaf
  std::vector<int> roots;                      // one for each part of the tissue, the large ones first; what is held is a part by itself
};

Forest forestOf(const FactorColumns& f) {
  const std::size_t n = f.start.size() - 1;
  Forest t{std::vector<std::vector<int>>(n), std::vector<int>(n, 0), {}};
  for (int j = 0; j < static_cast<int>(n); ++j) {
    const auto rows = rowsOf(f, j);
    t.chain[j] += static_cast<int>(rows.size()) + 1;
    if (rows.empty()) { t.roots.push_back(j); continue; }
    t.children[rows[0]].push_back(j);
    t.chain[rows[0]] = std::max(t.chain[rows[0]], t.chain[j]);
  }
  std::stable_sort(t.roots.begin(), t.roots.end(), [&](int a, int b) { return t.chain[a] > t.chain[b]; });
  return t;
}

/// The entries of columns, the longest first, as they are used.
void addAbreast(const FactorColumns& f, std::vector<int> columns, ProjectiveModel& p) {
  std::stable_sort(columns.begin(), columns.end(), [&](int a, int b) { return rowsOf(f, a).size() > rowsOf(f, b).size(); });
  ProjectiveModel::Abreast abreast;
  for (std::size_t n = 0; n < columns.size(); ++n) {
    abreast.index[n] = columns[n];
    abreast.count[n] = static_cast<int>(rowsOf(f, columns[n]).size());
  }
  for (int k = 0; k < abreast.count[0]; ++k)
    for (std::size_t n = 0; n < columns.size() && k < abreast.count[n]; ++n) {
      p.backRow.push_back(4 * f.row[f.start[columns[n]] + k]);
      p.backValue.push_back(f.value[f.start[columns[n]] + k]);
    }
  p.backward.push_back(abreast);
}

/// Of the columns of one part whose turn may come those go first that the longest chains wait for.
void scheduleBackward(const FactorColumns& f, const Forest& t, int root, ProjectiveModel& p) {
  std::set<std::array<int, 2>> ready{{t.chain[root], root}};           // longest chain last
  while (!ready.empty()) {
    std::vector<int> columns;
    while (columns.size() < ProjectiveModel::Abreast{}.index.size() && !ready.empty()) {
      columns.push_back((*ready.rbegin())[1]);
      ready.erase(std::prev(ready.end()));
    }
    for (const int column : columns)
      for (const int child : t.children[column]) ready.insert({t.chain[child], child});
    addAbreast(f, columns, p);
  }
}

/// Which part each column belongs to.
void nameParts(const Forest& t, ProjectiveModel& p) {
  std::vector<int> part(t.children.size(), 0);
  for (std::size_t k = 0; k < t.roots.size(); ++k) part[t.roots[k]] = std::min(static_cast<int>(k), ProjectiveModel::kMostParts - 1);
  for (int j = static_cast<int>(part.size()) - 1; j >= 0; --j)         // parents come after their children
    for (int child : t.children[j]) part[child] = part[j];
  for (ProjectiveModel::Panel& panel : p.panels) panel.part = part[panel.first];
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
  const Forest forest = forestOf(f);
  nameParts(forest, p);
  for (std::size_t k = 0; k < forest.roots.size(); ++k) {
    if (static_cast<int>(k) < ProjectiveModel::kMostParts)
      p.parts.push_back({static_cast<int>(p.backward.size()), 0, static_cast<int>(p.backValue.size())});
    scheduleBackward(f, forest, forest.roots[k], p);
    p.parts.back().end = static_cast<int>(p.backward.size());
  }
}

}  // namespace halsted
