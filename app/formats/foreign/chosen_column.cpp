#include "app/formats/foreign/chosen_column.hpp"

#include <fmt/format.h>

#include <utility>

#include "app/formats/foreign/foreign_heading.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

/// Name of a column and a factor for the column's numbers, from "log.csv:S*-0.00012" or "S/1341.4".
struct ScaledName {
  std::string column;
  double factor = 1;
};

/// Returns the possible meanings of `text`: the name of a column and, if a number follows the last * or /, a name with
/// a factor or divisor.
std::vector<ScaledName> measurementsOf(const std::string& text) {
  std::vector<ScaledName> measurements{{text}};
  const std::size_t at = text.find_last_of("*/");
  if (at == std::string::npos) return measurements;
  const auto number = tubesheets::parseNumber(tubesheets::trimBlanks(std::string_view(text).substr(at + 1)));
  if (number && *number != 0)
    measurements.push_back({std::string(tubesheets::trimBlanks(std::string_view(text).substr(0, at))),
                            text[at] == '*' ? *number : 1 / *number});
  return measurements;
}

/// Returns the index of the quantity that a name such as "x_mm" or "x" denotes, and the unit in the name; the unit is
/// null if the name states none.
std::pair<std::size_t, const Unit*> targetOf(const std::string& name, const std::vector<ColumnTarget>& targets) {
  std::vector<std::string> known;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const auto& target = targets[k];
    known.push_back(target.quantity);
    if (name == target.quantity) return {k, nullptr};
    if (!target.unit || !name.starts_with(target.quantity + "_")) continue;
    const std::string_view word = std::string_view(name).substr(target.quantity.size() + 1);
    if (const Unit* unit = unitOfKind(findUnitWord(word), *target.unit)) return {k, unit};
  }
  throw InputError::problem("--column", "a measurement table has no column " + inQuotes(name),
                            suggestionOr(name, known, "`tubeplan readings CELL --template` prints an empty one"));
}

struct FoundColumn {
  std::size_t table = 0, column = 0;
  double factor = 1;
};

FoundColumn columnOf(const std::string& theirs, const std::vector<ForeignTable>& tables) {
  std::vector<FoundColumn> found;
  std::vector<std::string> known;
  for (const auto& [name, factor] : measurementsOf(theirs)) {
    for (std::size_t t = 0; t < tables.size(); ++t)
      for (std::size_t c = 0; c < tables[t].columns.size(); ++c) {
        known.push_back(tables[t].columns[c]);
        if (name == tables[t].columns[c] || name == tables[t].file + ":" + tables[t].columns[c])
          found.push_back({t, c, factor});
      }
    if (!found.empty()) break;
  }
  if (found.size() == 1) return found.front();
  if (found.empty())
    throw InputError("--column", "the unknown column " + inQuotes(theirs), alternatives(known),
                     suggestion(theirs, known));
  throw InputError::problem("--column", fmt::format("{} columns have the name {}", found.size(), inQuotes(theirs)),
                            fmt::format("write {}:{}", tables[found.front().table].file, theirs));
}

}  // namespace

ChosenColumn parseChosenColumn(const std::string& chosen, const std::vector<ForeignTable>& tables,
                               const std::vector<ColumnTarget>& targets) {
  const std::size_t equals = chosen.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == chosen.size())
    throw InputError("--column", inQuotes(chosen), "NAME=COLUMN, such as x_mm=X", "");
  const auto [target, unit] = targetOf(chosen.substr(0, equals), targets);
  const auto [table, column, factor] = columnOf(chosen.substr(equals + 1), tables);
  if (factor != 1 && (!targets[target].is_number || targets[target].form))
    throw InputError::problem(
        "--column", fmt::format("the column of {} cannot have a factor", inQuotes(chosen)),
        "give the column without a factor; only joints, coordinates and other single numbers can have a factor");
  return {target, table, column, unit, factor};
}

}  // namespace tubeplan::app
