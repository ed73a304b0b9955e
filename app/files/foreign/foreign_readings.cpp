#include "app/files/foreign/foreign_readings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "app/files/foreign/clock_time.hpp"
#include "app/files/input_error.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using tubesheets::csvField, tubesheets::parseNumber;

/// What stands for nothing in tables that leave no field empty.
bool isBlank(const std::string& field) {
  return field.empty() || field == "-" || field == "--" || field == "NaN" || field == "nan" || field == "n/a" ||
         field == "N/A";
}

/// Without the groups before it: "A::Group::P1" is "P1".
std::string pointName(const std::string& field) {
  const std::size_t colons = field.rfind("::");
  return std::string(tubesheets::trimBlanks(colons == std::string::npos ? field : field.substr(colons + 2)));
}

/// Row k of the readings is row rows[t][k] of table t.
using RowsTogether = std::vector<std::vector<std::size_t>>;

class ForeignReader {
 public:
  ForeignReader(const ForeignRequest& request, const deflection::Arm& arm)
      : request_(request),
        targets_(columnTargets(arm)),
        taken_(takeColumns(request.tables, targets_, request.choice)) {}

  ForeignReadings read() {
    joinTables();
    nameColumns();
    findIds();
    std::vector<std::string> names = {"id"};
    if (!isTaken("kind")) names.emplace_back("kind");
    for (const auto& column : taken_)
      if (column.name != "id") names.push_back(csvField(column.name));
    out_.text = fmt::format("{}\n", fmt::join(names, ","));
    std::size_t lost = 0;
    for (std::size_t k = 0; k < rows_[lead_].size(); ++k) {
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

  /// The table with the joints leads; the others follow it.
  void joinTables() {
    const std::size_t tables = request_.tables.size();
    rows_.resize(tables);
    const auto joint =
        std::find_if(taken_.begin(), taken_.end(), [&](const auto& c) { return targets_[c.target].is_joint; });
    lead_ = joint->table;
    std::vector<std::vector<std::optional<std::size_t>>> partners(tables);
    for (std::size_t t = 0; t < tables; ++t)
      if (t != lead_ && isUsed(t)) partners[t] = partnersOf(t);
    for (std::size_t k = 0; k < table(lead_).rows.size(); ++k) {
      const bool is_whole = std::all_of(partners.begin(), partners.end(),
                                        [&](const auto& partner) { return partner.empty() || partner[k]; });
      if (!is_whole) continue;
      for (std::size_t t = 0; t < tables; ++t) rows_[t].push_back(partners[t].empty() ? k : *partners[t][k]);
    }
    if (rows_[lead_].empty())
      throw InputError(table(lead_).file, "no row that another table has a point for", "rows with the same names", "");
    if (const std::size_t lost = table(lead_).rows.size() - rows_[lead_].size(); lost > 0)
      out_.left_out.push_back(
          fmt::format("{} rows of {} whose names another table does not have", lost, table(lead_).file));
  }

  [[nodiscard]] bool isUsed(std::size_t t) const {
    return std::any_of(taken_.begin(), taken_.end(), [&](const auto& column) { return column.table == t; });
  }

  [[nodiscard]] std::vector<std::optional<std::size_t>> partnersOf(std::size_t t) {
    const auto ours = keyOf(lead_), theirs = keyOf(t);
    if (ours && theirs) {
      auto partners = partnersByName(t, *ours, *theirs);
      if (std::any_of(partners.begin(), partners.end(), [](const auto& partner) { return partner.has_value(); }))
        return partners;
      refuseOtherNames(t, *ours, *theirs);
    }
    return partnersByOrder(t);
  }

  /// Running numbers may count anything; names of points are names of points.
  void refuseOtherNames(std::size_t t, std::size_t ours, std::size_t theirs) const {
    const auto areNames = [](const ForeignTable& table, std::size_t column) {
      return std::none_of(table.rows.begin(), table.rows.end(),
                          [&](const auto& row) { return parseNumber(row.fields[column]).has_value(); });
    };
    if (areNames(table(lead_), ours) && areNames(table(t), theirs))
      throw InputError(table(t).file, fmt::format("names of which {} has none", table(lead_).file),
                       "the same names in both", "give the points the same names, or remove them to match by order");
  }

  std::vector<std::optional<std::size_t>> partnersByName(std::size_t t, std::size_t ours, std::size_t theirs) {
    std::map<std::string, std::size_t> index;
    for (std::size_t k = 0; k < table(t).rows.size(); ++k) {
      const auto& row = table(t).rows[k];
      if (!index.emplace(pointName(row.fields[theirs]), k).second)
        throw InputError(fmt::format("{}:{}", table(t).file, row.line),
                         fmt::format("the name {} twice", inQuotes(row.fields[theirs])), "every name once",
                         "give the points different names, or remove the names to match rows by their order");
    }
    std::vector<std::optional<std::size_t>> partners;
    std::set<std::size_t> used;
    for (const auto& row : table(lead_).rows) {
      const auto found = index.find(pointName(row.fields[ours]));
      partners.push_back(found == index.end() ? std::nullopt : std::optional(found->second));
      if (partners.back()) used.insert(*partners.back());
    }
    if (!used.empty()) {
      how_ = "by name";
      if (used.size() < index.size())
        out_.left_out.push_back(fmt::format("{} rows of {} whose names {} does not have", index.size() - used.size(),
                                            table(t).file, table(lead_).file));
    }
    return partners;
  }

  std::vector<std::optional<std::size_t>> partnersByOrder(std::size_t t) {
    const std::size_t ours = table(lead_).rows.size(), theirs = table(t).rows.size();
    if (ours != theirs)
      throw InputError(table(t).file,
                       fmt::format("{} rows, and none with a name that {} has", theirs, table(lead_).file),
                       fmt::format("{} rows, as {} has, or the same names in both", ours, table(lead_).file), "");
    how_ = "row by row";
    std::vector<std::optional<std::size_t>> partners;
    for (std::size_t k = 0; k < ours; ++k) partners.emplace_back(k);
    return partners;
  }

  void nameColumns() {
    std::vector<std::set<std::size_t>> used(request_.tables.size());
    for (const auto& column : taken_) {
      used[column.table].insert(column.column);
      out_.taken.push_back(fmt::format("{}: {} of {}", column.name,
                                       inQuotes(table(column.table).columns[column.column]), table(column.table).file));
    }
    if (!how_.empty()) out_.taken.push_back(fmt::format("the tables' rows are matched {}", how_));
    for (std::size_t t = 0; t < request_.tables.size(); ++t) {
      if (const auto key = keyOf(t); key && how_ == "by name") used[t].insert(*key);
      std::vector<std::string> left;
      for (std::size_t c = 0; c < table(t).columns.size(); ++c)
        if (!used[t].contains(c)) left.push_back(inQuotes(table(t).columns[c]));
      if (!left.empty()) out_.left_out.push_back(fmt::format("of {}: {}", table(t).file, fmt::join(left, ", ")));
    }
  }

  [[nodiscard]] std::string fieldOf(const TakenColumn& column, std::size_t k) const {
    return table(column.table).rows[rows_[column.table][k]].fields[column.column];
  }

  /// Ids must differ: where they do not, they are points' names that were measured again.
  void findIds() {
    const TakenColumn* column = find("id");
    if (!column) column = find("point");
    std::set<std::string> seen;
    for (std::size_t k = 0; k < rows_[lead_].size(); ++k) {
      ids_.push_back(column ? pointName(fieldOf(*column, k)) : "");
      if (ids_.back().empty() || !seen.insert(ids_.back()).second) column = nullptr;
    }
    if (column) return;
    for (std::size_t k = 0; k < ids_.size(); ++k) ids_[k] = fmt::format("{}", k + 1);
  }

  [[nodiscard]] std::string kindOf() const {
    if (!request_.kind.empty()) return request_.kind;
    if (isTaken("x") || isTaken("y") || isTaken("z")) return "position";
    if (isTaken("point")) return "touch";
    throw InputError("the columns", "no coordinates and no points", "x, y and z, or the points that were touched",
                     "say which columns they are (--column x_mm=COLUMN), or of what kind the readings are (--kind)");
  }

  [[nodiscard]] bool isLost(std::size_t k) const {
    if (isTaken("kind") || !request_.kind.empty() || kindOf() != "position") return false;
    return std::ranges::all_of(std::array{"x", "y", "z"}, [&](const char* axis) {
      const TakenColumn* column = find(axis);
      return !column || isBlank(fieldOf(*column, k));
    });
  }

  [[nodiscard]] std::string originOf(std::size_t k) const {
    std::string text;
    for (std::size_t t = 0; t < request_.tables.size(); ++t)
      if (isUsed(t))
        text += fmt::format("{}{}:{}", text.empty() ? "" : " and ", table(t).file, table(t).rows[rows_[t][k]].line);
    return text;
  }

  void addRow(std::size_t k) {
    out_.origins.push_back(originOf(k));
    std::vector<std::string> fields = {csvField(ids_[k])};
    if (!isTaken("kind")) fields.push_back(kindOf());
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
    if (targets_[column.target].unit == UnitKind::kTime)
      if (const auto seconds = clockSeconds(field)) return formatNumber(*seconds - firstTime(column));
    throw InputError(fmt::format("{}:{} (column {})", table(column.table).file,
                                 table(column.table).rows[rows_[column.table][k]].line,
                                 inQuotes(table(column.table).columns[column.column])),
                     inQuotes(field), "a finite number", "");
  }

  /// Of a clock, in seconds; times count from the first reading's.
  [[nodiscard]] double firstTime(const TakenColumn& column) const {
    return clockSeconds(fieldOf(column, 0)).value_or(0);
  }

  const ForeignRequest& request_;
  std::vector<ColumnTarget> targets_;
  std::vector<TakenColumn> taken_;
  RowsTogether rows_;
  std::size_t lead_ = 0;
  std::string how_;  ///< "by name", "row by row"; empty of one table
  std::vector<std::string> ids_;
  ForeignReadings out_;
};

}  // namespace

ForeignReadings readForeign(const ForeignRequest& request, const deflection::Arm& arm) {
  return ForeignReader(request, arm).read();
}

}  // namespace tubeplan::app
