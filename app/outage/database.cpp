#include "app/outage/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cassert>
#include <filesystem>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

constexpr int kBusyTimeout = 5000;  // longest time to wait for another writer [ms]

constexpr const char* kWriterSettings =
    "PRAGMA foreign_keys = ON; PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;";
constexpr const char* kReaderSettings = "SELECT 1 FROM sqlite_master";  // fails if the file cannot be read

/// Returns true if the file could not be opened because it or its folder is write-protected.
bool isProtected(int code) {
  const int kind = code & 0xff;
  return kind == SQLITE_CANTOPEN || kind == SQLITE_READONLY || kind == SQLITE_PERM || kind == SQLITE_AUTH;
}

/// Returns the name by which SQLite opens a file as immutable: no process changes it.
std::string unchangingName(const std::string& path) {
  std::string name = "file:";
  for (const char c : path)
    name += std::string_view("%?#").find(c) == std::string_view::npos ? std::string(1, c) : fmt::format("%{:02X}", c);
  return name + "?immutable=1";
}

struct Finalizer {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using StatementPointer = std::unique_ptr<sqlite3_stmt, Finalizer>;

void bindValue(sqlite3_stmt* statement, int index, const DatabaseValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value))
    sqlite3_bind_int64(statement, index, *integer);
  else if (const auto* real = std::get_if<double>(&value))
    sqlite3_bind_double(statement, index, *real);
  else if (const auto* text = std::get_if<std::string>(&value))
    sqlite3_bind_text(statement, index, text->data(), static_cast<int>(text->size()), SQLITE_TRANSIENT);
  else
    sqlite3_bind_null(statement, index);
}

DatabaseValue valueAt(sqlite3_stmt* statement, int column) {
  switch (sqlite3_column_type(statement, column)) {
    case SQLITE_INTEGER:
      return static_cast<std::int64_t>(sqlite3_column_int64(statement, column));
    case SQLITE_FLOAT:
      return sqlite3_column_double(statement, column);
    case SQLITE_NULL:
      return std::monostate{};
    default:
      return std::string(reinterpret_cast<const char*>(sqlite3_column_text(statement, column)),
                         static_cast<std::size_t>(sqlite3_column_bytes(statement, column)));
  }
}

DatabaseRow rowOf(sqlite3_stmt* statement) {
  std::vector<DatabaseValue> values;
  for (int column = 0; column < sqlite3_column_count(statement); ++column) values.push_back(valueAt(statement, column));
  return DatabaseRow(std::move(values));
}

}  // namespace

double DatabaseRow::real(std::size_t column) const {
  const DatabaseValue& value = values_.at(column);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::get<double>(value);
}

std::string DatabaseRow::text(std::size_t column) const {
  return isNull(column) ? "" : std::get<std::string>(values_.at(column));
}

void Database::Closer::operator()(sqlite3* database) const { sqlite3_close(database); }

Database::Database(const std::string& path, Mode mode) : path_(path), is_read_(mode == Mode::kRead) {
  std::error_code none;
  if (mode == Mode::kOpen && !std::filesystem::exists(path, none))
    throw InputError::problem(path, "no such file", "make it by `tubeplan job create JOB.yaml --out " + path + "`");
  const int create = mode == Mode::kCreate ? SQLITE_OPEN_CREATE : 0;
  int code = open(path, SQLITE_OPEN_READWRITE | create);
  if (mode == Mode::kRead && isProtected(code)) {
    // To read a file in WAL mode, SQLite writes other files next to it, unless it opens the file as immutable. Without
    // a log next to it, no process has the file open.
    const bool has_log = std::filesystem::file_size(path + "-wal", none) > 0 && !none;
    code =
        has_log ? open(path, SQLITE_OPEN_READONLY) : open(unchangingName(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    if (has_log && isProtected(code))
      throw InputError::problem(path, "changes are stored in " + path + "-wal, but this folder is write-protected",
                                "copy both files to a folder that you may write to");
  }
  if (code != SQLITE_OK) fail(code);
}

int Database::open(const std::string& name, int flags) {
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &opened, flags, nullptr);
  database_.reset(opened);
  if (code != SQLITE_OK) return code;
  sqlite3_busy_timeout(opened, kBusyTimeout);
  const bool writes = (flags & SQLITE_OPEN_READWRITE) != 0;
  if (writes && sqlite3_db_readonly(opened, "main") == 1) return SQLITE_READONLY;
  return sqlite3_exec(opened, writes ? kWriterSettings : kReaderSettings, nullptr, nullptr, nullptr);
}

void Database::fail(int code) const {
  const int kind = code & 0xff;
  if (kind == SQLITE_BUSY || kind == SQLITE_LOCKED)
    throw InputError::problem(path_, "another program keeps this file locked", "try again when it has finished");
  if (kind == SQLITE_NOTADB || kind == SQLITE_CORRUPT)
    throw InputError::problem(path_, "this file is not the record of a job, or it is damaged",
                              "name a file that `tubeplan job create` made");
  if (isProtected(code))
    throw InputError::problem(path_, fmt::format("this file cannot be {}", is_read_ ? "read" : "opened for writing"),
                              "check its folder and permissions");
  if (kind == SQLITE_FULL || kind == SQLITE_IOERR)
    throw InputError::problem(path_, "this file cannot be written", "check the space left on the disk");
  const std::string message = sqlite3_errmsg(database_.get());
  if (message.starts_with("no such "))
    throw InputError::problem(path_, "the record is damaged: " + message, "restore it from a copy");
  throw std::logic_error(path_ + ": " + message);
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

std::vector<DatabaseRow> Database::query(std::string_view sql, const std::vector<DatabaseValue>& parameters) {
  sqlite3_stmt* prepared = nullptr;
  const int code = sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()), &prepared, nullptr);
  const StatementPointer statement(prepared);
  if (code != SQLITE_OK) fail(code);
  assert(sqlite3_bind_parameter_count(prepared) == static_cast<int>(parameters.size()));
  for (std::size_t k = 0; k < parameters.size(); ++k) bindValue(prepared, static_cast<int>(k) + 1, parameters[k]);
  std::vector<DatabaseRow> rows;
  int step = SQLITE_OK;
  while ((step = sqlite3_step(prepared)) == SQLITE_ROW) rows.push_back(rowOf(prepared));
  if (step != SQLITE_DONE) fail(step);
  return rows;
}

std::int64_t Database::lastKey() const { return sqlite3_last_insert_rowid(database_.get()); }

void Database::transact(const std::function<void()>& work) {
  execute("BEGIN IMMEDIATE");
  try {
    work();
    execute("COMMIT");
  } catch (...) {
    sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
}

}  // namespace tubeplan::app
