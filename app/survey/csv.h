#pragma once
/// A small CSV reader: commas, double quotes, CR LF or LF; empty lines are skipped. Every row has as many fields as the header.
#include <string>
#include <vector>

namespace halsted::app {

struct CsvRow {
  int line = 0;
  std::vector<std::string> fields;
};

struct CsvTable {
  std::string file;
  std::vector<std::string> header;
  std::vector<CsvRow> rows;

  /// "file:line: what"
  [[noreturn]] void fail(int line, const std::string& what) const;
  /// The column of that name; throws when it is not there or there twice.
  int column(const std::string& name) const;
  double number(const CsvRow&, int column) const;   // [any] throws naming line and column when the field is empty or not a number
};

/// Throws scenes::InputError "file:line: ...".
CsvTable readCsv(const std::string& file);

}  // namespace halsted::app
