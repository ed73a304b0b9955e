// SQLite database: one file, statements with bound values, transactions. Nothing else in the program calls SQLite.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

struct sqlite3;

namespace tubeplan::app {

/// Value of a column or a bound parameter; the first alternative is NULL.
using DatabaseValue = std::variant<std::monostate, std::int64_t, double, std::string>;

/// One row of a query's result.
class DatabaseRow {
 public:
  explicit DatabaseRow(std::vector<DatabaseValue> values) : values_(std::move(values)) {}

  /// Return the value of a column, counted from 0, which must have that type. A NULL text is returned as empty.
  [[nodiscard]] std::int64_t integer(std::size_t column) const { return std::get<std::int64_t>(values_.at(column)); }
  [[nodiscard]] double real(std::size_t column) const;
  [[nodiscard]] std::string text(std::size_t column) const;
  [[nodiscard]] bool isNull(std::size_t column) const { return values_.at(column).index() == 0; }

 private:
  std::vector<DatabaseValue> values_;
};

/// An open database file. Not thread-safe: each thread opens its own.
class Database {
 public:
  enum class Mode { kOpen, kCreate, kRead };

  /// Opens an existing file, or creates a new one, which must not exist. A file that is only read may be
  /// write-protected and in a folder that is. Throws InputError for a missing file and for a file that is not a
  /// database.
  Database(const std::string& path, Mode mode);

  [[nodiscard]] const std::string& path() const { return path_; }

  /// Executes one or more statements without parameters.
  void execute(const std::string& sql);

  /// Executes one statement with its parameters (?1, ?2, ...), and returns all rows of its result. Throws InputError if
  /// the file cannot be read or written, for example because another program keeps it locked.
  std::vector<DatabaseRow> query(std::string_view sql, const std::vector<DatabaseValue>& parameters = {});

  /// Returns the key of the row that the last INSERT added.
  [[nodiscard]] std::int64_t lastKey() const;

  /// Calls `work` in a transaction that excludes other writers from its start. All of its changes are kept together; if
  /// `work` throws an exception, none is.
  void transact(const std::function<void()>& work);

 private:
  struct Closer {
    void operator()(sqlite3* database) const;
  };

  /// Opens the file, and returns SQLite's code. After a failure the connection still exists, for its message.
  int open(const std::string& name, int flags);
  [[noreturn]] void fail(int code) const;

  std::string path_;
  bool is_read_;
  std::unique_ptr<sqlite3, Closer> database_;
};

}  // namespace tubeplan::app
