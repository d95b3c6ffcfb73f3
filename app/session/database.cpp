#include "app/session/database.h"

#include <sqlite3.h>

namespace halsted::app {
namespace {

constexpr int kBusyMilliseconds = 5000;        // [ms]

void check(sqlite3* handle, int code) {
  if (code != SQLITE_OK && code != SQLITE_ROW && code != SQLITE_DONE)
    throw DatabaseError{code, handle ? sqlite3_errmsg(handle) : sqlite3_errstr(code)};
}

}  // namespace

void Database::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
void Statement::Finalize::operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }

Database::Database(const std::string& path, Mode mode) {
  // Reading opens for writing where it may: after a kill SQLite must roll the unfinished transaction back.
  const int flags = mode == Mode::kCreate ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READWRITE;
  sqlite3* raw = nullptr;
  const std::string place = path.rfind('/', 0) == 0 ? path : "./" + path;   // ":memory:" and "file:" are names like any other
  const int code = sqlite3_open_v2(place.c_str(), &raw, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  handle_.reset(raw);
  check(raw, code);
  sqlite3_busy_timeout(raw, kBusyMilliseconds);                    // somebody may look at a session while it is recorded
  sqlite3_limit(raw, SQLITE_LIMIT_LENGTH, 256 << 20);              // a hostile file cannot ask for more than this
  sqlite3_db_config(raw, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
}

void Database::execute(const std::string& sql) { check(handle_.get(), sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr)); }

std::int64_t Database::pragma(const std::string& name) {
  Statement statement = prepare("PRAGMA " + name);
  return statement.step() ? statement.integer(0) : 0;
}

Statement::Statement(sqlite3* handle, const std::string& sql) {
  sqlite3_stmt* raw = nullptr;
  check(handle, sqlite3_prepare_v2(handle, sql.c_str(), -1, &raw, nullptr));
  handle_.reset(raw);
}

Statement& Statement::bind(int index, std::int64_t value) {
  check(sqlite3_db_handle(handle_.get()), sqlite3_bind_int64(handle_.get(), index, value));
  return *this;
}
Statement& Statement::bind(int index, double value) {
  check(sqlite3_db_handle(handle_.get()), sqlite3_bind_double(handle_.get(), index, value));
  return *this;
}
Statement& Statement::bind(int index, const std::string& value) {
  check(sqlite3_db_handle(handle_.get()),
        sqlite3_bind_text(handle_.get(), index, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT));
  return *this;
}
Statement& Statement::bind(int index, std::span<const std::uint8_t> value) {
  check(sqlite3_db_handle(handle_.get()),
        sqlite3_bind_blob64(handle_.get(), index, value.data(), value.size(), SQLITE_TRANSIENT));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(handle_.get());
  check(sqlite3_db_handle(handle_.get()), code);
  return code == SQLITE_ROW;
}

void Statement::run() {
  while (step()) {}
  sqlite3_reset(handle_.get());
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_.get(), column); }
double Statement::real(int column) const { return sqlite3_column_double(handle_.get(), column); }

std::string Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
  return text ? std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))) : std::string();
}

Blob Statement::blob(int column) const {
  const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(handle_.get(), column));
  return data ? Blob(data, data + sqlite3_column_bytes(handle_.get(), column)) : Blob();
}

}  // namespace halsted::app
