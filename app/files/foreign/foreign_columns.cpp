#include "app/files/foreign/foreign_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "app/files/foreign/clock_time.hpp"
#include "app/files/foreign/column_names.hpp"
#include "app/files/input_error.hpp"
#include "app/files/suggestion.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

std::string exampleOf(UnitKind kind) { return kind == UnitKind::kLength ? "mm" : unitNames(kind).front(); }

class ColumnTaker {
 public:
  ColumnTaker(const std::vector<ForeignTable>& tables, const std::vector<ColumnTarget>& targets,
              const ColumnChoice& choice)
      : tables_(tables), targets_(targets), choice_(choice), headings_(columnNames(tables, targets)) {
    for (const auto& table : tables) free_.emplace_back(table.columns.size(), true);
  }

  std::vector<TakenColumn> take() {
    for (const auto& chosen : choice_.columns) takeChosen(chosen);
    for (std::size_t k = 0; k < targets_.size(); ++k)
      if (!isTaken(k)) takeNamed(k);
    for (std::size_t k = 0; k < targets_.size(); ++k)
      if (targets_[k].is_joint && !isTaken(k)) missingJoint(k);
    std::sort(taken_.begin(), taken_.end(), [](const auto& a, const auto& b) { return a.target < b.target; });
    return std::move(taken_);
  }

 private:
  [[nodiscard]] bool isTaken(std::size_t target) const {
    return std::any_of(taken_.begin(), taken_.end(), [&](const auto& column) { return column.target == target; });
  }

  [[nodiscard]] std::string nameOf(std::size_t table, std::size_t column) const {
    return fmt::format("{} of {}", inQuotes(tables_[table].columns[column]), tables_[table].file);
  }

  void takeChosen(const std::string& chosen) {
    const std::size_t equals = chosen.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == chosen.size())
      throw InputError("--column", inQuotes(chosen), "NAME=COLUMN, such as x_mm=X", "");
    const std::string name = chosen.substr(0, equals);
    const auto [target, unit] = targetOf(name);
    if (isTaken(target)) throw InputError("--column", fmt::format("{} twice", inQuotes(name)), "it once", "");
    const auto [table, column] = columnOf(chosen.substr(equals + 1));
    add(target, table, column, unit);
  }

  /// "x_mm" or "x": a quantity, and the unit where the name states one.
  [[nodiscard]] std::pair<std::size_t, const Unit*> targetOf(const std::string& name) const {
    std::vector<std::string> known;
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      const auto& target = targets_[k];
      known.push_back(target.quantity);
      if (name == target.quantity) return {k, nullptr};
      if (!target.unit || !name.starts_with(target.quantity + "_")) continue;
      if (const Unit* unit = findUnit(*target.unit, name.substr(target.quantity.size() + 1))) return {k, unit};
    }
    throw InputError("--column", inQuotes(name), "a column of a measurement table", suggestion(name, known));
  }

  [[nodiscard]] std::pair<std::size_t, std::size_t> columnOf(const std::string& theirs) const {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    std::vector<std::string> known;
    for (std::size_t t = 0; t < tables_.size(); ++t)
      for (std::size_t c = 0; c < tables_[t].columns.size(); ++c) {
        known.push_back(tables_[t].columns[c]);
        if (theirs == tables_[t].columns[c] || theirs == tables_[t].file + ":" + tables_[t].columns[c])
          found.emplace_back(t, c);
      }
    if (found.size() == 1) return found.front();
    if (found.empty())
      throw InputError("--column", "no column " + inQuotes(theirs), alternatives(known), suggestion(theirs, known));
    throw InputError("--column", fmt::format("{} columns {}", found.size(), inQuotes(theirs)), "one",
                     fmt::format("write {}:{}", tables_[found.front().first].file, theirs));
  }

  void takeNamed(std::size_t k) {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t t = 0; t < tables_.size(); ++t)
      for (std::size_t c = 0; c < headings_[t].size(); ++c)
        if (free_[t][c] && fits(targets_[k], headings_[t][c]) && !isOtherTime(k, t, c)) found.emplace_back(t, c);
    if (found.empty()) return;
    if (found.size() > 1 && targets_[k].is_number) {
      std::vector<std::string> names;
      for (const auto& [t, c] : found) names.push_back(nameOf(t, c));
      throw InputError("the columns",
                       fmt::format("{}, which could each be {}", fmt::join(names, " and "), targets_[k].quantity),
                       "one",
                       fmt::format("say which: --column {}={}:{}", targets_[k].quantity, tables_[found[0].first].file,
                                   tables_[found[0].first].columns[found[0].second]));
    }
    add(k, found[0].first, found[0].second, nullptr);
  }

  void add(std::size_t target, std::size_t table, std::size_t column, const Unit* stated) {
    const auto& wanted = targets_[target];
    std::string name = wanted.quantity;
    if (wanted.unit) {
      const Unit* unit = stated ? stated : unitOf(*wanted.unit, table, column);
      if (!unit)
        throw InputError("the column " + nameOf(table, column), "no unit",
                         fmt::format("{} with its unit: {}", wanted.quantity, alternatives(unitNames(*wanted.unit))),
                         fmt::format("write --units {0}, or --column {1}_{0}={2}", exampleOf(*wanted.unit),
                                     wanted.quantity, tables_[table].columns[column]));
      name += "_" + std::string(unit->name);
    }
    free_[table][column] = false;
    taken_.push_back({std::move(name), target, table, column});
  }

  [[nodiscard]] const std::string& firstField(std::size_t table, std::size_t column) const {
    return tables_[table].rows.front().fields[column];
  }
  [[nodiscard]] bool isClock(std::size_t table, std::size_t column) const {
    return clockSeconds(firstField(table, column)).has_value();
  }
  /// A time that is written in some way of its own is left out, as a date is.
  [[nodiscard]] bool isOtherTime(std::size_t target, std::size_t table, std::size_t column) const {
    const std::string& field = firstField(table, column);
    return targets_[target].unit == UnitKind::kTime && !field.empty() && !tubesheets::parseNumber(field) &&
           !isClock(table, column);
  }

  [[nodiscard]] const Unit* unitOf(UnitKind kind, std::size_t table, std::size_t column) const {
    if (kind == UnitKind::kTime && isClock(table, column)) return findUnit(kind, "s");
    const Unit* stated = headings_[table][column].unit;
    if (stated && stated->kind == kind) return stated;
    const auto usual = choice_.units.find(kind);
    return usual == choice_.units.end() ? nullptr : usual->second;
  }

  [[noreturn]] void missingJoint(std::size_t k) const {
    std::vector<std::string> left;
    for (std::size_t t = 0; t < tables_.size(); ++t)
      for (std::size_t c = 0; c < free_[t].size(); ++c)
        if (free_[t][c]) left.push_back(tables_[t].columns[c]);
    const std::string& name = targets_[k].quantity;
    throw InputError("the columns", "none for the joint " + name,
                     left.empty() ? "one for every joint" : "one of " + alternatives(left),
                     fmt::format("say which: --column {}=COLUMN", name));
  }

  const std::vector<ForeignTable>& tables_;
  const std::vector<ColumnTarget>& targets_;
  const ColumnChoice& choice_;
  std::vector<std::vector<ForeignHeading>> headings_;
  std::vector<std::vector<bool>> free_;
  std::vector<TakenColumn> taken_;
};

}  // namespace

std::optional<std::size_t> findNames(const ForeignTable& table, const std::vector<ColumnTarget>& targets) {
  const auto headings = columnNames(table, targets);
  for (const char* quantity : {"point", "id"})
    for (const auto& target : targets) {
      if (target.quantity != quantity) continue;
      const auto found = std::find_if(headings.begin(), headings.end(), [&](const auto& h) { return fits(target, h); });
      if (found != headings.end()) return static_cast<std::size_t>(found - headings.begin());
    }
  return std::nullopt;
}

std::vector<std::optional<ColumnGuess>> guessColumns(const std::vector<ForeignTable>& tables,
                                                     const std::vector<ColumnTarget>& targets) {
  const auto headings = columnNames(tables, targets);
  std::vector<std::optional<ColumnGuess>> guesses(targets.size());
  std::set<std::pair<std::size_t, std::size_t>> used;
  for (std::size_t k = 0; k < targets.size(); ++k)
    for (std::size_t t = 0; t < tables.size(); ++t)
      for (std::size_t c = 0; c < headings[t].size() && !guesses[k]; ++c)
        if (fits(targets[k], headings[t][c]) && used.emplace(t, c).second) guesses[k] = {t, c, headings[t][c].unit};
  return guesses;
}

std::vector<TakenColumn> takeColumns(const std::vector<ForeignTable>& tables, const std::vector<ColumnTarget>& targets,
                                     const ColumnChoice& choice) {
  return ColumnTaker(tables, targets, choice).take();
}

}  // namespace tubeplan::app
