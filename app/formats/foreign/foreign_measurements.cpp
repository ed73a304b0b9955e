#include "app/formats/foreign/foreign_measurements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "app/formats/foreign/angle_fields.hpp"
#include "app/formats/foreign/clock_time.hpp"
#include "app/formats/foreign/column_names.hpp"
#include "app/formats/foreign/foreign_heading.hpp"
#include "app/formats/foreign/form_columns.hpp"
#include "app/formats/foreign/joined_rows.hpp"
#include "app/storage/count_text.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "tubesheets/csv_table.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::app {

namespace {

using tubesheets::csvField, tubesheets::parseNumber;

class ForeignReader {
 public:
  ForeignReader(const ForeignRequest& request, const deflection::Arm& arm)
      : request_(request),
        targets_(columnTargets(arm)),
        taken_(takeColumns(request.tables, targets_, request.choice, request.kind)) {}

  ForeignMeasurements read() {
    refuseUnused();
    joinTables();
    nameColumns();
    kind_ = kindOf();
    requireTurn();
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
    if (lost > 0) out_.left_out.push_back(countText(lost, "row") + " without coordinates");
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

  /// Returns the column that names the rows of table t: the column assigned to points or ids, otherwise the result of
  /// findNames().
  [[nodiscard]] std::optional<std::size_t> keyOf(std::size_t t) const {
    for (const char* quantity : {"point", "id"})
      if (const auto* column = find(quantity); column && column->table == t) return column->column;
    return findNames(table(t), targets_);
  }

  /// Throws InputError if no column of a file is used.
  void refuseUnused() const {
    for (std::size_t t = 0; t < request_.tables.size(); ++t)
      if (!isUsed(t))
        throw InputError::problem(table(t).file, "no column is recognised as joints, coordinates or points",
                                  "say which columns they are (--column x_mm=COLUMN), or leave the file out");
  }

  /// Matches the rows of all tables with the rows of the table that contains the joints.
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
      if (column.form)
        used[column.table].insert(column.form->columns.begin(), column.form->columns.end());
      else
        used[column.table].insert(column.column);
      out_.taken.push_back(fmt::format("{}: {}", column.name, sourceOf(column)));
    }
    if (!joined_.how.empty()) out_.taken.push_back(fmt::format("the tables' rows are matched {}", joined_.how));
    for (std::size_t t = 0; t < request_.tables.size(); ++t) {
      if (const auto key = keyOf(t); key && joined_.how.find("by name") != std::string::npos) used[t].insert(*key);
      std::vector<std::string> unused;
      for (std::size_t c = 0; c < table(t).columns.size(); ++c) {
        if (used[t].contains(c)) continue;
        unused.push_back(inQuotes(table(t).columns[c]));
        if (areNumbers(t, c)) unknown_numbers_.push_back(fmt::format("{} of {}", unused.back(), table(t).file));
      }
      for (const auto& remark : table(t).remarks) out_.taken.push_back(fmt::format("of {}: {}", table(t).file, remark));
      noteOmittedTurn(t, used[t]);
      if (!unused.empty()) out_.left_out.push_back(fmt::format("of {}: {}", table(t).file, fmt::join(unused, ", ")));
    }
  }

  [[nodiscard]] std::string sourceOf(const TakenColumn& column) const {
    if (column.form) {
      const bool is_explained = column.part == 0 && !column.form->why.empty();
      return fmt::format("{} as {}{}{}", namesOf(*column.form, request_.tables), column.form->form->name,
                         *column.form->taken ? fmt::format(", {}", column.form->taken) : "",
                         is_explained ? fmt::format(" (their numbers are {})", column.form->why) : "");
    }
    const std::string factor = column.factor == 1 ? "" : fmt::format(" times {}", formatNumber(column.factor));
    return fmt::format("{} of {}{}", inQuotes(table(column.table).columns[column.column]), table(column.table).file,
                       factor);
  }

  /// If the measurements have no orientation, reports unused columns that look like an orientation.
  void noteOmittedTurn(std::size_t t, const std::set<std::size_t>& used) {
    if (isTaken(columnsOf(Stated::kTurn).columns.front())) return;
    const auto headings = columnNames(request_.tables, targets_);
    FreeColumns free;
    for (const auto& other : request_.tables) free.emplace_back(other.columns.size(), false);
    for (std::size_t c = 0; c < free[t].size(); ++c) free[t][c] = !used.contains(c);
    const auto forms = formsByHeadings({request_.tables, headings, request_.choice.units, free, {}}, Stated::kTurn, "");
    if (!forms.empty())
      out_.left_out.push_back(fmt::format("an orientation, {}, which --kind pose or orientation reads",
                                          namesOf(forms.front(), request_.tables)));
  }

  /// Throws InputError if the requested kind of measurements measures an orientation but no column states one.
  void requireTurn() const {
    const StatedColumns& turn = columnsOf(Stated::kTurn);
    if (request_.kind.empty() || !neededForms({request_.kind}, {}).contains(Stated::kTurn)) return;
    if (std::ranges::any_of(turn.columns, [&](const char* name) { return isTaken(name); })) return;
    throw InputError::problem(
        "the columns",
        fmt::format("none states the orientation of readings of kind {}, either as {} or as the numbers of {}",
                    request_.kind, fmt::join(turn.columns, ", "), alternatives(formNames(Stated::kTurn))),
        "say which columns they are: --column euler-zyx.z_deg=COLUMN and so on");
  }

  [[nodiscard]] bool areNumbers(std::size_t t, std::size_t column) const {
    const auto& rows = table(t).rows;
    const auto isNumber = [&](const ForeignRow& row) { return parseNumber(row.fields[column]).has_value(); };
    return std::ranges::any_of(rows, isNumber) && std::ranges::all_of(rows, [&](const ForeignRow& row) {
             return isBlankField(row.fields[column]) || isNumber(row);
           });
  }

  [[nodiscard]] std::string fieldOf(const TakenColumn& column, std::size_t k) const {
    return rowOf(column, k).fields[column.column];
  }

  /// Determines the ids of the measurements: the table's ids or, if it has none, its point names; running numbers if
  /// these are missing or not unique.
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
    const bool has_place = isTaken("x") || isTaken("y") || isTaken("z");
    const auto* turn = find(columnsOf(Stated::kTurn).columns.front());
    if (turn && turn->form) return has_place ? "pose" : "orientation";
    if (has_place) return "position";
    if (!isTaken("point"))
      throw InputError::problem(
          "the columns", "none is recognised as coordinates x, y, z or as the points that were touched",
          "say which columns they are (--column x_mm=COLUMN), or which kind the readings are (--kind)");
    if (!unknown_numbers_.empty() && !areHoles())
      throw InputError::problem(
          "the columns",
          fmt::format("none is recognised as coordinates x, y, z, and the numbers in {} have no known meaning",
                      fmt::join(unknown_numbers_, ", ")),
          "say which columns they are (--column x_mm=COLUMN), or give all three columns of polar "
          "coordinates (--column polar.horizontal_gon=COLUMN); or say that the readings are touches (--kind touch)");
    return "touch";
  }

  /// Returns true if all points have names of holes, whose positions the sheet states.
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
      return !column || isEmptyAt(*column, k);
    });
  }

  [[nodiscard]] const ForeignRow& rowOf(const TakenColumn& column, std::size_t k) const {
    return table(column.table).rows[joined_.rows[column.table][k]];
  }

  /// Returns true if the column's field is empty or, for a computed component, if any field of its form is empty.
  [[nodiscard]] bool isEmptyAt(const TakenColumn& column, std::size_t k) const {
    if (!column.form) return isBlankField(fieldOf(column, k));
    const auto& fields = rowOf(column, k).fields;
    return std::ranges::any_of(column.form->columns, [&](std::size_t c) { return isBlankField(fields[c]); });
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
    if (column.form) return formField(column, k);
    if (isBlankField(field)) return "";
    if (const auto value = numberIn(field, column.unit)) {
      const std::string number = field.starts_with('+') ? field.substr(1) : field;
      return column.factor == 1 && parseNumber(number) ? number : formatNumber(*value * column.factor);
    }
    const auto clock = clocks_.find(column.target);
    if (clock == clocks_.end()) refuseField(column, column.column, k, expectedOf(column.unit, field));
    if (const auto seconds = clock->second[joined_.rows[column.table][k]]) return formatNumber(*seconds);
    refuseField(column, column.column, k, "a time in the same form as in the other rows");
  }

  /// Returns a description of valid fields in a unit, for messages.
  [[nodiscard]] static const char* expectedOf(const Unit* unit, const std::string& field) {
    if (unit == sixtiethsOfHours()) return "hours as 12:34:56.7 or 12h34m56.7s, minutes and seconds within 60";
    if (unit == sixtiethsOfDegrees()) return "degrees as 12:34:56.7 or 12d34'56.7\", minutes and seconds within 60";
    return parseSexagesimal(field) ? "an angle in the unit that its heading states" : "a finite number";
  }

  [[noreturn]] void refuseField(const TakenColumn& column, std::size_t at, std::size_t k, const char* expected) const {
    throw InputError(fmt::format("{}:{} (column {})", table(column.table).file, rowOf(column, k).line,
                                 inQuotes(table(column.table).columns[at])),
                     inQuotes(rowOf(column, k).fields[at]), expected, "");
  }

  /// Returns one component of the orientation or position that the columns of a form state together.
  [[nodiscard]] std::string formField(const TakenColumn& column, std::size_t k) const {
    const FormColumns& columns = *column.form;
    const auto& fields = rowOf(column, k).fields;
    if (std::ranges::all_of(columns.columns, [&](std::size_t c) { return isBlankField(fields[c]); })) return "";
    const auto numbers = numbersOf(columns, rowOf(column, k));
    if (!numbers)
      for (std::size_t i = 0; i < columns.columns.size(); ++i)
        if (const std::size_t c = columns.columns[i]; !numberIn(fields[c], columns.units[i]))
          refuseField(column, c, k, expectedOf(columns.units[i], fields[c]));
    if (columns.form->fit(*numbers) == FormFit::kImpossible) refuseNumbers(column, k);
    const UnitKind kind = columnsOf(columns.form->stated).unit;
    const Unit* unit = findUnit(kind, column.name.substr(column.name.rfind('_') + 1));
    const auto part = static_cast<Eigen::Index>(column.part);
    return formatNumber(columns.form->read(*numbers)[part] / unit->factor);
  }

  [[noreturn]] void refuseNumbers(const TakenColumn& column, std::size_t k) const {
    const FormColumns& columns = *column.form;
    std::vector<std::string> found;
    for (const std::size_t c : columns.columns) found.push_back(rowOf(column, k).fields[c]);
    throw InputError(fmt::format("{}:{}", table(column.table).file, rowOf(column, k).line),
                     fmt::format("{} for {}", fmt::join(found, ", "), namesOf(columns, request_.tables)),
                     fmt::format("a {}, {}", columns.form->name, columns.form->usual),
                     "correct the row or say what the columns are");
  }

  /// Converts clock times to seconds since the first measurement that states a time.
  void readClocks() {
    for (const auto& column : taken_) {
      if (targets_[column.target].unit != UnitKind::kTime) continue;
      std::vector<std::string> fields;
      for (const auto& row : table(column.table).rows) fields.push_back(row.fields[column.column]);
      ClockTimes times = clockTimes(fields, dateOrderOf(column, fields));
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

  /// Returns the order of day and month in the column's dates. Throws InputError unless it is clear or chosen.
  [[nodiscard]] DateOrder dateOrderOf(const TakenColumn& column, const std::vector<std::string>& fields) const {
    constexpr std::array kOrders{DateOrder::kDayFirst, DateOrder::kMonthFirst};
    if (const std::string& requested_order = request_.choice.dates; !requested_order.empty()) {
      const auto order =
          std::ranges::find(kOrders, requested_order, [](DateOrder known) { return std::string(nameOf(known)); });
      if (order == kOrders.end())
        throw InputError("--dates", inQuotes(requested_order), "day-first or month-first", "");
      return *order;
    }
    const auto orders = dateOrders(fields);
    if (orders.size() < 2) return orders.empty() ? DateOrder::kMonthFirst : orders.front();
    const auto first = std::ranges::find_if(fields, isClockTime);
    throw InputError::problem(
        fmt::format("the column {} of {}", inQuotes(table(column.table).columns[column.column]),
                    table(column.table).file),
        fmt::format("the day may be the first number or the second, as in {}: neither is greater than 12 in any row",
                    inQuotes(*first)),
        "say which: --dates day-first or --dates month-first");
  }

  const ForeignRequest& request_;
  std::vector<ColumnTarget> targets_;
  std::vector<TakenColumn> taken_;
  JoinedRows joined_;
  std::vector<std::string> ids_;
  std::vector<std::string> unknown_numbers_;                          ///< columns of numbers that no quantity uses
  std::string kind_;                                                  ///< kind of measurements if the table states none
  std::map<std::size_t, std::vector<std::optional<double>>> clocks_;  ///< times of the rows [s], keyed by target
  ForeignMeasurements out_;
};

}  // namespace

ForeignMeasurements readForeign(const ForeignRequest& request, const deflection::Arm& arm) {
  return ForeignReader(request, arm).read();
}

}  // namespace tubeplan::app
