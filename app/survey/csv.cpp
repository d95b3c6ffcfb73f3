#include "app/survey/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "scenes/input_text.h"

namespace halsted::app {
namespace {

constexpr std::size_t kMostBytes = 16u << 20;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> fieldsOf(const std::string& line, const CsvTable& table, int number) {
  std::vector<std::string> fields(1);
  bool inQuotes = false, wasQuoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && inQuotes && i + 1 < line.size() && line[i + 1] == '"') { fields.back() += line[++i]; continue; }
    if (c == '"') { inQuotes = !inQuotes; wasQuoted = true; continue; }
    if (c != ',' || inQuotes) { fields.back() += c; continue; }
    if (!wasQuoted) fields.back() = trimmed(fields.back());
    fields.emplace_back();
    wasQuoted = false;
  }
  if (inQuotes) table.fail(number, "a quote is not closed");
  if (!wasQuoted) fields.back() = trimmed(fields.back());
  return fields;
}

}  // namespace

void CsvTable::fail(int line, const std::string& what) const {
  throw scenes::InputError(scenes::quoted(file) + ":" + std::to_string(line) + ": " + scenes::quoted(what));
}

int CsvTable::column(const std::string& name) const {
  const auto at = std::find(header.begin(), header.end(), name);
  if (at == header.end()) fail(1, "no column " + name);
  if (std::find(at + 1, header.end(), name) != header.end()) fail(1, "column " + name + " is there twice");
  return static_cast<int>(at - header.begin());
}

double CsvTable::number(const CsvRow& row, int column) const {
  const std::string& text = row.fields[column];
  if (text.empty()) fail(row.line, header[column] + ": is missing");
  double value = 0.0;                          // [any]
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    fail(row.line, header[column] + ": " + text + " is not a number");
  return value;
}

CsvTable readCsv(const std::string& file) {
  CsvTable table;
  table.file = file;
  std::string text = scenes::readTextFile(file, kMostBytes);
  if (text.rfind("\xef\xbb\xbf", 0) == 0) text.erase(0, 3);
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!scenes::isUtf8(line)) table.fail(number, "bytes that are not UTF-8");
    if (trimmed(line).empty()) continue;
    std::vector<std::string> fields = fieldsOf(line, table, number);
    if (table.header.empty()) { table.header = std::move(fields); continue; }
    if (fields.size() != table.header.size())
      table.fail(number, std::to_string(fields.size()) + " fields, the header has " + std::to_string(table.header.size()));
    table.rows.push_back({number, std::move(fields)});
  }
  if (table.rows.empty()) throw scenes::InputError(scenes::quoted(file) + ": no rows");
  return table;
}

}  // namespace halsted::app
