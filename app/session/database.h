#pragma once
/// SQLite with its handles owned and its errors thrown. One thread at a time.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace halsted::app {

/// What went wrong in SQLite's words; the caller adds the file's name and what it means.
struct DatabaseError {
  int code = 0;
  std::string what;
};

using Blob = std::vector<std::uint8_t>;

class Statement {
 public:
  Statement(sqlite3*, const std::string& sql);
  Statement& bind(int index, std::int64_t);
  Statement& bind(int index, double);          // [unit of the column]
  Statement& bind(int index, const std::string&);
  Statement& bind(int index, std::span<const std::uint8_t>);
  bool step();                                 // true: a row is there
  void run();                                  // to the end, then ready for the next binding
  std::int64_t integer(int column) const;
  double real(int column) const;               // [unit of the column]
  std::string text(int column) const;
  Blob blob(int column) const;

 private:
  struct Finalize { void operator()(sqlite3_stmt*) const; };
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

class Database {
 public:
  enum class Mode { kRead, kCreate };
  Database(const std::string& path, Mode);     // throws DatabaseError
  void execute(const std::string& sql);
  std::int64_t pragma(const std::string& name);
  Statement prepare(const std::string& sql) { return Statement(handle_.get(), sql); }

 private:
  struct Close { void operator()(sqlite3*) const; };
  std::unique_ptr<sqlite3, Close> handle_;
};

}  // namespace halsted::app
