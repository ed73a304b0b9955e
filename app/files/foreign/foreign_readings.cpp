#include "app/files/foreign/foreign_readings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "app/files/foreign/clock_time.hpp"
#include "app/files/foreign/joined_rows.hpp"
#include "app/files/input_error.hpp"
#include "tubesheets/csv_table.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::app {

namespace {

using tubesheets::csvField, tubesheets::parseNumber;

/// What stands for nothing in tables that leave no field empty.
bool isBlank(const std::string& field) {
  return field.empty() || field == "-" || field == "--" || field == "NaN" || field == "nan" || field == "n/a" ||
         field == "N/A";
}

class ForeignReader {
 public:
  ForeignReader(const ForeignRequest& request, const deflection::Arm& arm)
      : request_(request),
        targets_(columnTargets(arm)),
        taken_(takeColumns(request.tables, targets_, request.choice)) {}

  ForeignReadings read() {
    refuseUnused();
    joinTables();
    nameColumns();
    kind_ = kindOf();
    findIds();
    readClocks();
    std::vector<std::string> names = {"id"};
    if (!isTaken("kind")) names.emplace_back("kind");
    for (const auto& column : taken_)
      if (column.name != "id") names.push_back(csvField(column.name));
    out_.text = fmt::format("{}\n", fmt::join(names, ","));
    std::size_t lost = 0;
    for (std::size_t k = 0; k < joined_.rows[joined_.lead].size(); ++k) {
      if (isLost(k))
        ++lost;
      else
        addRow(k);
    }
    if (lost > 0) out_.left_out.push_back(fmt::format("{} rows without coordinates", lost));
    return std::move(out_);
  }

 private:
  [[nodiscard]] const ForeignTable& table(std::size_t t) const { return request_.tables[t]; }

  [[nodiscard]] const TakenColumn* find(const std::string& quantity) const {
    for (const auto& column : taken_)
      if (targets_[column.target].quantity == quantity) return &column;
    return nullptr;
  }
  [[nodiscard]] bool isTaken(const std::string& quantity) const { return find(quantity) != nullptr; }

  /// The column with the names of a table's rows: the chosen one, else what its heading says.
  [[nodiscard]] std::optional<std::size_t> keyOf(std::size_t t) const {
    for (const char* quantity : {"point", "id"})
      if (const auto* column = find(quantity); column && column->table == t) return column->column;
    return findNames(table(t), targets_);
  }

  /// A file of which nothing is known was given for something.
  void refuseUnused() const {
    for (std::size_t t = 0; t < request_.tables.size(); ++t)
      if (!isUsed(t))
        throw InputError(table(t).file, "no column that is recognised", "joints, coordinates or points",
                         "say which columns they are (--column x_mm=COLUMN), or leave the file out");
  }

  /// The table with the joints leads; the others follow it.
  void joinTables() {
    const auto joint =
        std::find_if(taken_.begin(), taken_.end(), [&](const auto& c) { return targets_[c.target].is_joint; });
    std::vector<std::optional<std::size_t>> names;
    for (std::size_t t = 0; t < request_.tables.size(); ++t) names.push_back(keyOf(t));
    joined_ = joinRows(request_.tables, joint->table, names);
    out_.left_out = joined_.left_out;
  }

  [[nodiscard]] bool isUsed(std::size_t t) const {
    return std::any_of(taken_.begin(), taken_.end(), [&](const auto& column) { return column.table == t; });
  }

  void nameColumns() {
    std::vector<std::set<std::size_t>> used(request_.tables.size());
    for (const auto& column : taken_) {
      used[column.table].insert(column.column);
      out_.taken.push_back(fmt::format("{}: {} of {}", column.name,
                                       inQuotes(table(column.table).columns[column.column]), table(column.table).file));
    }
    if (!joined_.how.empty()) out_.taken.push_back(fmt::format("the tables' rows are matched {}", joined_.how));
    for (std::size_t t = 0; t < request_.tables.size(); ++t) {
      if (const auto key = keyOf(t); key && joined_.how == "by name") used[t].insert(*key);
      std::vector<std::string> left;
      for (std::size_t c = 0; c < table(t).columns.size(); ++c) {
        if (used[t].contains(c)) continue;
        left.push_back(inQuotes(table(t).columns[c]));
        if (areNumbers(t, c)) unknown_numbers_.push_back(fmt::format("{} of {}", left.back(), table(t).file));
      }
      if (!left.empty()) out_.left_out.push_back(fmt::format("of {}: {}", table(t).file, fmt::join(left, ", ")));
    }
  }

  [[nodiscard]] bool areNumbers(std::size_t t, std::size_t column) const {
    const auto& rows = table(t).rows;
    const auto isNumber = [&](const ForeignRow& row) { return parseNumber(row.fields[column]).has_value(); };
    return std::ranges::any_of(rows, isNumber) && std::ranges::all_of(rows, [&](const ForeignRow& row) {
             return isBlank(row.fields[column]) || isNumber(row);
           });
  }

  [[nodiscard]] std::string fieldOf(const TakenColumn& column, std::size_t k) const {
    return table(column.table).rows[joined_.rows[column.table][k]].fields[column.column];
  }

  /// Ids must differ: where they do not, they are points' names that were measured again.
  void findIds() {
    const TakenColumn* column = find("id");
    if (!column) column = find("point");
    std::set<std::string> seen;
    for (std::size_t k = 0; k < joined_.rows[joined_.lead].size(); ++k) {
      ids_.push_back(column ? pointName(fieldOf(*column, k)) : "");
      if (ids_.back().empty() || !seen.insert(ids_.back()).second) column = nullptr;
    }
    if (column) return;
    for (std::size_t k = 0; k < ids_.size(); ++k) ids_[k] = fmt::format("{}", k + 1);
  }

  [[nodiscard]] std::string kindOf() const {
    if (!request_.kind.empty() || isTaken("kind")) return request_.kind;
    if (isTaken("x") || isTaken("y") || isTaken("z")) return "position";
    if (!isTaken("point"))
      throw InputError("the columns", "no coordinates and no points", "x, y and z, or the points that were touched",
                       "say which columns they are (--column x_mm=COLUMN), or of what kind the readings are (--kind)");
    if (!unknown_numbers_.empty() && !areHoles())
      throw InputError(
          "the columns",
          fmt::format("no coordinates, and numbers that are not recognised: {}", fmt::join(unknown_numbers_, ", ")),
          "x, y and z, or touches of points alone",
          "say which columns they are (--column x_mm=COLUMN), with polar coordinates made x, y and z "
          "before; or say that the readings are touches (--kind touch)");
    return "touch";
  }

  /// Whether the points are named as holes are, whose places the sheet gives.
  [[nodiscard]] bool areHoles() const {
    const TakenColumn& point = *find("point");
    for (std::size_t k = 0; k < joined_.rows[joined_.lead].size(); ++k)
      if (!tubesheets::parseTubeName(pointName(fieldOf(point, k)))) return false;
    return true;
  }

  [[nodiscard]] bool isLost(std::size_t k) const {
    if (!request_.kind.empty() || kind_ != "position") return false;
    return std::ranges::all_of(std::array{"x", "y", "z"}, [&](const char* axis) {
      const TakenColumn* column = find(axis);
      return !column || isBlank(fieldOf(*column, k));
    });
  }

  [[nodiscard]] std::string originOf(std::size_t k) const {
    std::string text;
    for (std::size_t t = 0; t < request_.tables.size(); ++t)
      if (isUsed(t))
        text +=
            fmt::format("{}{}:{}", text.empty() ? "" : " and ", table(t).file, table(t).rows[joined_.rows[t][k]].line);
    return text;
  }

  void addRow(std::size_t k) {
    out_.origins.push_back(originOf(k));
    std::vector<std::string> fields = {csvField(ids_[k])};
    if (!isTaken("kind")) fields.push_back(kind_);
    for (const auto& column : taken_) {
      const auto& target = targets_[column.target];
      if (target.quantity == "id") continue;
      const std::string field = fieldOf(column, k);
      fields.push_back(target.is_number             ? numberField(column, k, field)
                       : target.quantity == "point" ? csvField(pointName(field))
                                                    : csvField(field));
    }
    out_.text += fmt::format("{}\n", fmt::join(fields, ","));
  }

  [[nodiscard]] std::string numberField(const TakenColumn& column, std::size_t k, const std::string& field) const {
    if (isBlank(field)) return "";
    const std::string number = field.starts_with('+') ? field.substr(1) : field;
    if (parseNumber(number)) return number;
    if (const auto clock = clocks_.find(column.target); clock != clocks_.end())
      if (const auto seconds = clock->second[joined_.rows[column.table][k]]) return formatNumber(*seconds);
    throw InputError(fmt::format("{}:{} (column {})", table(column.table).file,
                                 table(column.table).rows[joined_.rows[column.table][k]].line,
                                 inQuotes(table(column.table).columns[column.column])),
                     inQuotes(field), "a finite number", "");
  }

  /// Clocks' times count from the first reading's that states one.
  void readClocks() {
    for (const auto& column : taken_) {
      if (targets_[column.target].unit != UnitKind::kTime) continue;
      std::vector<std::string> fields;
      for (const auto& row : table(column.table).rows) fields.push_back(row.fields[column.column]);
      ClockTimes times = clockTimes(fields);
      for (const std::size_t k : times.midnights)
        out_.taken.push_back(fmt::format("{}: the clock passes midnight before {}:{}, a day is added from there on",
                                         column.name, table(column.table).file, table(column.table).rows[k].line));
      const auto& rows = joined_.rows[column.table];
      const auto first = std::ranges::find_if(rows, [&](std::size_t k) { return times.seconds[k].has_value(); });
      if (first == rows.end()) continue;
      const double start = *times.seconds[*first];
      for (auto& seconds : times.seconds)
        if (seconds) *seconds -= start;
      clocks_.emplace(column.target, std::move(times.seconds));
    }
  }

  const ForeignRequest& request_;
  std::vector<ColumnTarget> targets_;
  std::vector<TakenColumn> taken_;
  JoinedRows joined_;
  std::vector<std::string> ids_;
  std::vector<std::string> unknown_numbers_;                          ///< columns of numbers that are left out
  std::string kind_;                                                  ///< of readings whose table names none
  std::map<std::size_t, std::vector<std::optional<double>>> clocks_;  ///< s, by target, of every row of the table
  ForeignReadings out_;
};

}  // namespace

ForeignReadings readForeign(const ForeignRequest& request, const deflection::Arm& arm) {
  return ForeignReader(request, arm).read();
}

}  // namespace tubeplan::app
