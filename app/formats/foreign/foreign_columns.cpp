#include "app/formats/foreign/foreign_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "app/formats/foreign/angle_fields.hpp"
#include "app/formats/foreign/chosen_column.hpp"
#include "app/formats/foreign/clock_time.hpp"
#include "app/formats/foreign/column_names.hpp"
#include "app/formats/foreign/form_columns.hpp"
#include "app/formats/foreign/joint_patterns.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"
#include "app/storage/suggestion.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

std::string exampleOf(UnitKind kind) { return kind == UnitKind::kLength ? "mm" : unitNames(kind).front(); }

class ColumnTaker {
 public:
  ColumnTaker(const std::vector<ForeignTable>& tables, const std::vector<ColumnTarget>& targets,
              const ColumnChoice& choice, const std::string& kind)
      : tables_(tables), targets_(targets), choice_(choice), kind_(kind), headings_(columnNames(tables, targets)) {
    for (const auto& table : tables) free_.emplace_back(table.columns.size(), true);
  }

  std::vector<TakenColumn> take() {
    for (const auto& chosen : choice_.columns) takeChosen(chosen);
    takeChosenForms();
    for (const auto& [stated, name] : neededForms(kindsOf(search(), kind_), choice_)) takeForm(stated, name);
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
    const ChosenColumn column = parseChosenColumn(chosen, tables_, targets_);
    if (isTaken(column.target) || std::ranges::find(parts_, column.target, &ChosenColumn::target) != parts_.end())
      throw InputError::problem("--column",
                                fmt::format("{} is assigned twice", inQuotes(targets_[column.target].quantity)),
                                "assign it once");
    if (!targets_[column.target].form)
      return add(column.target, column.table, column.column, column.unit, column.factor);
    free_[column.table][column.column] = false;
    parts_.push_back(column);
  }

  /// Adds the orientations and positions whose numbers the user chose column by column; all columns of a form must be
  /// in one table.
  void takeChosenForms() {
    while (!parts_.empty()) {
      const WrittenForm& form = *targets_[parts_.front().target].form;
      FormColumns columns{&form, parts_.front().table, {}, {}};
      for (std::size_t part = 0; part < form.numbers.size(); ++part) {
        const auto found = std::ranges::find_if(parts_, [&](const auto& chosen) {
          return targets_[chosen.target].form == &form && targets_[chosen.target].part == part;
        });
        if (found == parts_.end() || found->table != columns.table)
          throw InputError::problem("--column",
                                    fmt::format("{} needs {} numbers from one table, but its {} is missing", form.name,
                                                form.numbers.size(), form.numbers[part].name),
                                    fmt::format("add --column {}.{}=COLUMN", form.name, form.numbers[part].name));
        columns.columns.push_back(found->column);
        columns.units.push_back(found->unit);
      }
      std::erase_if(parts_, [&](const auto& chosen) { return targets_[chosen.target].form == &form; });
      addForm(std::move(columns), true);
    }
  }

  [[nodiscard]] FormSearch search() const {
    std::vector<const ColumnTarget*> joints;
    for (std::size_t k = 0; k < targets_.size(); ++k)
      if (targets_[k].is_joint && !isTaken(k)) joints.push_back(&targets_[k]);
    return {tables_, headings_, choice_.units, free_, std::move(joints)};
  }

  /// Returns true if a column directly states a component of an orientation or a position.
  [[nodiscard]] bool hasColumns(Stated stated) const {
    return std::ranges::any_of(columnsOf(stated).columns, [&](const char* name) {
      return isTaken(indexOf(name)) || hasFreeColumn(search(), targets_[indexOf(name)]);
    });
  }

  [[nodiscard]] std::size_t indexOf(std::string_view quantity) const {
    return static_cast<std::size_t>(std::ranges::find(targets_, quantity, &ColumnTarget::quantity) - targets_.begin());
  }

  /// Adds the orientation or position in the form with the given name. If the name is empty, adds it in the only form
  /// that fits, unless columns state it directly.
  void takeForm(Stated stated, const std::string& name) {
    const bool is_chosen = isTaken(indexOf(columnsOf(stated).columns.front()));
    if (is_chosen || (name.empty() && hasColumns(stated))) return;
    const auto names = formNames(stated);
    if (!name.empty()) (void)entryNamed(names, name, columnsOf(stated).option);
    if (auto form = onlyForm(formsByHeadings(search(), stated, name), tables_)) return addForm(std::move(*form));
    if (!name.empty()) missingForm(name);
  }

  [[noreturn]] static void missingForm(const std::string& name) {
    const auto& form = *std::ranges::find(writtenForms(), name, &WrittenForm::name);
    std::vector<std::string> numbers;
    for (const auto& number : form.numbers) numbers.push_back(fmt::format("--column {}.{}=COLUMN", name, number.name));
    throw InputError::problem(fmt::format("{} {}", columnsOf(form.stated).option, name),
                              fmt::format("no columns have the headings of this form ({})", form.words),
                              fmt::format("say which columns they are: {}", fmt::join(numbers, " ")));
  }

  void addForm(FormColumns columns, bool are_chosen = false) {
    const StatedColumns& stated = columnsOf(columns.form->stated);
    for (std::size_t i = 0; i < columns.columns.size(); ++i) {
      const auto& kind = columns.form->numbers[i].unit;
      if (kind == UnitKind::kAngle)
        requireOneForm(tables_[columns.table], columns.columns[i],
                       (are_chosen && columns.units[i]) || headings_[columns.table][columns.columns[i]].unit);
      if (kind && !columns.units[i])
        columns.units[i] = neededUnit(fmt::format("{}.{}", columns.form->name, columns.form->numbers[i].name), *kind,
                                      columns.table, columns.columns[i]);
      free_[columns.table][columns.columns[i]] = false;
    }
    const auto stating =
        std::ranges::find_if(columns.units, [&](const Unit* u) { return u && u->kind == stated.unit; });
    const auto usual = choice_.units.find(stated.unit);
    const Unit& unit = stating != columns.units.end() ? **stating
                       : usual != choice_.units.end() ? *usual->second
                                                      : *findUnit(stated.unit, unitNames(stated.unit).front());
    const auto shared = std::make_shared<const FormColumns>(std::move(columns));
    for (std::size_t part = 0; part < stated.columns.size(); ++part) {
      const std::size_t target = indexOf(stated.columns[part]);
      if (isTaken(target))
        throw InputError::problem(
            "--column", fmt::format("{} cannot be combined with {}", stated.columns[part], shared->form->name),
            "give one of them");
      taken_.push_back({fmt::format("{}_{}", stated.columns[part], ownUnitOf(unit).unit->name), target, shared->table,
                        shared->columns.front(), 1, shared, part});
    }
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
      throw InputError::problem(
          "the columns", fmt::format("{} could each be {}", fmt::join(names, " and "), targets_[k].quantity),
          fmt::format("say which: --column {}={}:{}", targets_[k].quantity, tables_[found[0].first].file,
                      tables_[found[0].first].columns[found[0].second]));
    }
    add(k, found[0].first, found[0].second, nullptr);
  }

  void add(std::size_t target, std::size_t table, std::size_t column, const Unit* stated, double factor = 1) {
    const auto& wanted = targets_[target];
    std::string name = wanted.quantity;
    const Unit* unit = nullptr;
    if (wanted.unit == UnitKind::kAngle)
      requireOneForm(tables_[table], column, stated || headings_[table][column].unit);
    if (wanted.unit) {
      unit = stated ? stated : neededUnit(wanted.quantity, *wanted.unit, table, column);
      const bool is_stated = stated || factor != 1 || headings_[table][column].unit;
      if (wanted.is_joint && !is_stated) refusePulses(wanted, table, column, *unit);
      if (wanted.is_joint && !stated && std::abs(factor) == 1 && unit->name == "deg")
        refuseDoubtfulDegrees(tables_[table], column, wanted.quantity);
      name += "_" + std::string(ownUnitOf(*unit).unit->name);
      factor *= ownUnitOf(*unit).factor;
    }
    free_[table][column] = false;
    taken_.push_back({std::move(name), target, table, column, factor, nullptr, 0, unit});
  }

  [[nodiscard]] const Unit* neededUnit(const std::string& quantity, UnitKind kind, std::size_t table,
                                       std::size_t column) const {
    const auto& heading = headings_[table][column];
    if (const Unit* unit = kind == UnitKind::kTime && isClock(table, column)
                               ? findUnit(kind, "s")
                               : unitOf(tables_[table], heading, kind, choice_.units))
      return unit;
    const std::string& theirs = tables_[table].columns[column];
    if (heading.is_count)
      throw InputError::problem(
          "the column " + nameOf(table, column),
          "its numbers are pulses, whose size as an angle or length is not stated",
          fmt::format("write --column '{}_{}={}*0.0001', with the size and sign of a pulse as the factor", quantity,
                      exampleOf(kind), theirs));
    throw InputError::problem(
        "the column " + nameOf(table, column),
        fmt::format("the unit of {} is not stated: {}", quantity, alternatives(unitNames(kind))),
        fmt::format("write --units {0}, or --column {1}_{0}={2}", exampleOf(kind), quantity, theirs));
  }

  /// Throws InputError for joint readings that are integers and would be many turns in the assumed unit, because they
  /// are probably encoder pulses.
  void refusePulses(const ColumnTarget& joint, std::size_t table, std::size_t column, const Unit& unit) const {
    constexpr double kMostTurns = 20;
    double most = 0;
    for (const auto& row : tables_[table].rows) {
      const auto number = tubesheets::parseInteger(row.fields[column]);
      if (!number && !isBlankField(row.fields[column])) return;
      if (number) most = std::max(most, std::abs(*number * unit.factor) / (2 * std::numbers::pi));
    }
    if (joint.unit != UnitKind::kAngle || most < kMostTurns) return;
    const std::string& theirs = tables_[table].columns[column];
    throw InputError::problem(
        "the column " + nameOf(table, column),
        fmt::format("its whole numbers would be up to {:.0f} turns as angles, so they may be pulses", most),
        fmt::format("write --column '{0}_{1}={2}*0.0001' with the size and sign of a pulse as the factor, or "
                    "--column {0}_{1}={2} if they are angles",
                    joint.quantity, unit.name, theirs));
  }

  [[nodiscard]] const std::string& firstField(std::size_t table, std::size_t column) const {
    return tables_[table].rows.front().fields[column];
  }
  [[nodiscard]] bool isClock(std::size_t table, std::size_t column) const {
    return isClockTime(firstField(table, column));
  }
  /// Returns true for a column of times in an unknown format, which is ignored.
  [[nodiscard]] bool isOtherTime(std::size_t target, std::size_t table, std::size_t column) const {
    const std::string& field = firstField(table, column);
    return targets_[target].unit == UnitKind::kTime && !field.empty() && !tubesheets::parseNumber(field) &&
           !isClock(table, column);
  }

  /// Throws InputError because several sets of columns could be the joints.
  [[noreturn]] void severalPatterns(const std::vector<JointColumns>& patterns) const {
    std::vector<std::string> sets, columns;
    for (const auto& [table, of_joints] : patterns)
      sets.push_back(fmt::format("{} to {}", nameOf(table, of_joints.front()), nameOf(table, of_joints.back())));
    std::size_t k = 0;
    for (const auto& target : targets_)
      if (isNumbered(target))
        columns.push_back(fmt::format("--column '{}={}'", target.quantity,
                                      tables_[patterns.front().table].columns[patterns.front().columns[k++]]));
    throw InputError::problem("the columns", fmt::format("{} could each be the joints", fmt::join(sets, " and ")),
                              fmt::format("say which, such as {}", fmt::join(columns, " ")));
  }

  [[noreturn]] void missingJoint(std::size_t k) const {
    if (const auto patterns = jointPatterns(tables_, headings_, targets_); patterns.size() > 1)
      severalPatterns(patterns);
    std::vector<std::string> unused;
    for (std::size_t t = 0; t < tables_.size(); ++t)
      for (std::size_t c = 0; c < free_[t].size(); ++c)
        if (free_[t][c]) unused.push_back(tables_[t].columns[c]);
    const std::string& name = targets_[k].quantity;
    throw InputError::problem("the columns",
                              fmt::format("none is recognised as the joint {}{}", name,
                                          unused.empty() ? "" : fmt::format(", which may be {}", alternatives(unused))),
                              fmt::format("say which: --column {}=COLUMN", name));
  }

  const std::vector<ForeignTable>& tables_;
  const std::vector<ColumnTarget>& targets_;
  const ColumnChoice& choice_;
  const std::string& kind_;
  std::vector<std::vector<ForeignHeading>> headings_;
  std::vector<ChosenColumn> parts_;  ///< columns that the user chose for numbers of written forms
  FreeColumns free_;
  std::vector<TakenColumn> taken_;
};

}  // namespace

std::vector<TakenColumn> takeColumns(const std::vector<ForeignTable>& tables, const std::vector<ColumnTarget>& targets,
                                     const ColumnChoice& choice, const std::string& kind) {
  return ColumnTaker(tables, targets, choice, kind).take();
}

}  // namespace tubeplan::app
