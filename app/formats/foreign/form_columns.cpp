#include "app/formats/foreign/form_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "app/formats/foreign/angle_fields.hpp"
#include "app/formats/foreign/column_names.hpp"
#include "app/storage/input_error.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/value_columns.hpp"

namespace tubeplan::app {

namespace {

constexpr double kSame = 1e-9;  // tolerance for equal results of two forms [rad or m]

/// Returns true if this column is the only possible one for some joint.
bool isOnlyJoint(const FormSearch& search, std::size_t table, std::size_t column) {
  FreeColumns others = search.free;
  others[table][column] = false;
  const FormSearch among_others{search.tables, search.headings, search.units, others, {}};
  return std::ranges::any_of(search.joints, [&](const ColumnTarget* joint) {
    return fits(*joint, search.headings[table][column]) && !hasFreeColumn(among_others, *joint);
  });
}

/// Returns the free column of table t with the given name; std::nullopt if there are several or the heading states
/// another kind of unit.
std::optional<std::size_t> columnCalled(const FormSearch& search, std::size_t t, const std::string& name,
                                        const std::optional<UnitKind>& unit) {
  std::optional<std::size_t> found;
  for (std::size_t c = 0; c < search.headings[t].size(); ++c) {
    const auto& heading = search.headings[t][c];
    if (heading.name != name || heading.is_count || !search.free[t][c] || isOnlyJoint(search, t, c)) continue;
    if (found || (heading.unit && heading.unit->kind != unit)) return std::nullopt;
    found = c;
  }
  return found;
}

bool hasColumn(const ForeignTable& table, const std::string& name) {
  return !name.empty() &&
         std::ranges::any_of(table.columns, [&](const auto& column) { return parseHeading(column).name == name; });
}

/// Returns the columns of table t with the headings of a form; std::nullopt unless all columns exist.
std::optional<FormColumns> columnsCalled(const FormSearch& search, std::size_t t, const WrittenForm& form,
                                         const FormHeadings& names) {
  FormColumns found{&form, t, {}, {}, hasColumn(search.tables[t], names.indicator), {}, names.taken};
  for (std::size_t i = 0; i < names.names.size(); ++i) {
    const auto& unit = form.numbers[i].unit;
    const auto column = columnCalled(search, t, names.names[i], unit);
    if (!column) return std::nullopt;
    found.columns.push_back(*column);
    found.units.push_back(unit ? unitOf(search.tables[t], search.headings[t][*column], *unit, search.units) : nullptr);
  }
  return found;
}

bool haveSameColumns(const FormColumns& a, const FormColumns& b) {
  return a.table == b.table && std::ranges::is_permutation(a.columns, b.columns);
}

bool hasUnits(const FormColumns& columns) {
  for (std::size_t i = 0; i < columns.columns.size(); ++i)
    if (columns.form->numbers[i].unit && !columns.units[i]) return false;
  return true;
}

/// Returns how plausible a table's numbers are in a form: as plausible as in the least plausible row.
FormFit fitOf(const FormColumns& columns, const ForeignTable& table) {
  FormFit fit = FormFit::kUsual;
  if (!hasUnits(columns)) return fit;
  for (const auto& row : table.rows)
    if (const auto numbers = numbersOf(columns, row)) fit = std::max(fit, columns.form->fit(*numbers));
  return fit;
}

bool readAlike(const FormColumns& a, const FormColumns& b, const std::vector<ForeignTable>& tables) {
  if (a.table != b.table || !hasUnits(a) || !hasUnits(b)) return false;
  return std::ranges::all_of(tables[a.table].rows, [&](const auto& row) {
    const auto first = numbersOf(a, row), second = numbersOf(b, row);
    return !first || !second || (a.form->read(*first) - b.form->read(*second)).cwiseAbs().maxCoeff() < kSame;
  });
}

/// Removes forms in which the numbers are less plausible than in the best form, and notes the removal in remaining
/// forms with the same columns.
void excludeByNumbers(std::vector<FormColumns>& forms, const std::vector<ForeignTable>& tables) {
  std::vector<FormFit> fits;
  for (const auto& columns : forms) fits.push_back(fitOf(columns, tables[columns.table]));
  const FormFit best = *std::ranges::min_element(fits);
  std::vector<FormColumns> plausible, excluded;
  for (std::size_t i = 0; i < forms.size(); ++i)
    (fits[i] == best ? plausible : excluded).push_back(std::move(forms[i]));
  for (auto& columns : plausible)
    for (const auto& other : excluded)
      if (haveSameColumns(columns, other))
        columns.why += fmt::format("{}no {}, {}", columns.why.empty() ? "" : "; ", other.form->name, other.form->usual);
  forms = std::move(plausible);
}

/// Removes forms if a further column of the table indicates another form of the same columns.
void excludeByColumns(std::vector<FormColumns>& forms) {
  std::vector<FormColumns> decided;
  std::ranges::copy_if(forms, std::back_inserter(decided), &FormColumns::is_indicated);
  std::erase_if(forms, [&](const auto& columns) {
    return !columns.is_indicated &&
           std::ranges::any_of(decided, [&](const auto& other) { return haveSameColumns(columns, other); });
  });
}

}  // namespace

bool hasFreeColumn(const FormSearch& search, const ColumnTarget& target) {
  for (std::size_t t = 0; t < search.headings.size(); ++t)
    for (std::size_t c = 0; c < search.headings[t].size(); ++c)
      if (search.free[t][c] && fits(target, search.headings[t][c])) return true;
  return false;
}

std::set<std::string> kindsOf(const FormSearch& search, const std::string& requested_kind) {
  if (!requested_kind.empty()) return {requested_kind};
  std::set<std::string> kinds;
  for (std::size_t t = 0; t < search.tables.size(); ++t)
    for (std::size_t c = 0; c < search.headings[t].size(); ++c)
      if (search.headings[t][c].name == "kind")
        for (const auto& row : search.tables[t].rows) kinds.insert(row.fields[c]);
  return kinds;
}

std::map<Stated, std::string> neededForms(const std::set<std::string>& kinds, const ColumnChoice& choice) {
  std::map<Stated, std::string> needed;
  if (!choice.orientation.empty()) needed[Stated::kTurn] = choice.orientation;
  if (!choice.points.empty() || kinds.empty()) needed[Stated::kPlace] = choice.points;
  for (const auto& name : kinds) {
    const auto* kind = calibration::findMeasurementKind(name);
    if (!kind) continue;
    const std::string_view turn = columnsOf(Stated::kTurn).columns.front();
    if (std::ranges::any_of(kind->columns, [&](const auto& column) { return column.name == turn; }))
      needed.try_emplace(Stated::kTurn);
    if (calibration::measuresPlace(*kind)) needed.try_emplace(Stated::kPlace);
  }
  return needed;
}

std::vector<FormColumns> formsByHeadings(const FormSearch& search, Stated stated, const std::string& name) {
  std::vector<FormColumns> found;
  for (const auto& form : writtenForms()) {
    if (form.stated != stated || (!name.empty() && name != form.name)) continue;
    for (std::size_t t = 0; t < search.tables.size(); ++t)
      for (const auto& names : form.headings)
        if (auto columns = columnsCalled(search, t, form, names)) found.push_back(std::move(*columns));
  }
  return found;
}

std::vector<FormColumns> decideForms(std::vector<FormColumns> forms, const std::vector<ForeignTable>& tables) {
  if (forms.size() < 2) return forms;
  excludeByColumns(forms);
  if (forms.size() > 1) excludeByNumbers(forms, tables);
  std::vector<FormColumns> distinct;
  for (auto& columns : forms)
    if (std::ranges::none_of(distinct, [&](const auto& other) { return readAlike(columns, other, tables); }))
      distinct.push_back(std::move(columns));
  return distinct;
}

std::optional<FormNumbers> numbersOf(const FormColumns& columns, const ForeignRow& row) {
  FormNumbers numbers{};
  for (std::size_t i = 0; i < columns.columns.size(); ++i) {
    const auto number = numberIn(row.fields[columns.columns[i]], columns.units[i]);
    if (!number) return std::nullopt;
    numbers[i] = *number * (columns.units[i] ? columns.units[i]->factor : 1);
  }
  return numbers;
}

std::string namesOf(const FormColumns& columns, const std::vector<ForeignTable>& tables) {
  std::vector<std::string> names;
  for (const std::size_t c : columns.columns) names.push_back(inQuotes(tables[columns.table].columns[c]));
  return fmt::format("{} of {}", fmt::join(names, ", "), tables[columns.table].file);
}

std::optional<FormColumns> onlyForm(const std::vector<FormColumns>& found, const std::vector<ForeignTable>& tables) {
  if (found.empty()) return std::nullopt;
  auto candidates = decideForms(found, tables);
  if (candidates.size() == 1) return std::move(candidates.front());
  const StatedColumns& stated = columnsOf(candidates.front().form->stated);
  std::vector<std::string> measurements, options;
  for (const auto& columns : candidates) {
    const bool is_same = haveSameColumns(columns, candidates.front());
    measurements.push_back(fmt::format("{}{} ({})", is_same ? "" : namesOf(columns, tables) + " as ",
                                       columns.form->name, columns.form->words));
    options.push_back(fmt::format("{} {}", stated.option, columns.form->name));
  }
  throw InputError::problem(
      "the columns " + namesOf(candidates.front(), tables),
      fmt::format("their numbers may state {} as {}", stated.word, fmt::join(measurements, ", or as ")),
      fmt::format("say which: {}", fmt::join(options, " or ")));
}

}  // namespace tubeplan::app
