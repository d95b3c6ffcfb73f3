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
  const ProjectiveModel::Panel panel{first, width, rows, static_cast<int>(p.row.size()), static_cast<int>(p.value.size())};
  for (int c = 0; c < width; ++c) p.row.push_back(4 * (first + c));
  for (int r : below) p.row.push_back(4 * r);
  p.value.resize(p.value.size() + static_cast<std::size_t>(rows * width), 0.0);
  for (int c = 0; c < width; ++c)
    for (int r = c + 1; r < rows; ++r) p.value[panel.value + r * width + c] = f.value[f.start[first + c] + r - c - 1];
  p.panels.push_back(panel);
}

std::vector<ProjectiveModel::Column> columnsOf(const ProjectiveModel& p) {
  std::vector<ProjectiveModel::Column> columns;
  for (const auto& panel : p.panels)
    for (int c = 0; c < panel.width; ++c)
      columns.push_back({panel.first + c, panel.row + c + 1, panel.value + (c + 1) * panel.width + c, panel.width, panel.rows - c - 1});
  return columns;
}

/// On the way back a column needs those of its rows, all of them above it in the elimination tree (Liu 1990). Of the columns whose
/// turn may come the two go first that the longest chains wait for.
void scheduleBackward(const FactorColumns& f, ProjectiveModel& p) {
  const auto columns = columnsOf(p);
  const int n = static_cast<int>(columns.size());
  std::vector<std::vector<int>> children(columns.size());
  std::vector<int> chain(columns.size(), 0);                           // entries from the column down to its farthest leaf
  std::set<std::array<int, 2>> ready;                                  // longest chain last
  for (int j = 0; j < n; ++j) {
    chain[j] += columns[j].count + 1;
    if (columns[j].count == 0) { ready.insert({chain[j], j}); continue; }
    const int parent = f.row[f.start[j]];
    children[parent].push_back(j);
    chain[parent] = std::max(chain[parent], chain[j]);
  }
  while (!ready.empty()) {
    std::array<ProjectiveModel::Column, 2> pair;
    for (auto& column : pair) {
      column.index = -1;
      if (ready.empty()) continue;
      column = columns[(*ready.rbegin())[1]];
      ready.erase(std::prev(ready.end()));
    }
    for (const auto& column : pair)
      if (column.index >= 0) for (int child : children[column.index]) ready.insert({chain[child], child});
    p.backward.push_back(pair);
  }
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
  scheduleBackward(f, p);
}

}  // namespace halsted
