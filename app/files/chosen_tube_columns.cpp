#include "app/files/chosen_tube_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/files/input_error.hpp"
#include "app/files/suggestion.hpp"
#include "app/files/text_file.hpp"

namespace tubeplan::app {

namespace {

using tubesheets::ChosenTubeColumn, tubesheets::TubeQuantity;

/// "x_mm" or "row": a quantity, and the unit of those that have one.
ChosenTubeColumn quantityOf(const std::string& name) {
  std::vector<std::string> known;
  for (const TubeQuantity& quantity : tubesheets::tubeQuantities()) {
    known.emplace_back(quantity.name);
    if (quantity.units.empty() && name == quantity.name) return {quantity.column, 0, nullptr};
    for (const std::string_view unit : quantity.units)
      if (name == fmt::format("{}_{}", quantity.name, unit))
        return {quantity.column, 0, tubesheets::findLengthUnit(unit)};
  }
  throw InputError("--column", inQuotes(name), "a column of a work list, lengths with their unit (x_mm)",
                   suggestion(name, known));
}

std::size_t placeOfChosen(const std::string& theirs, const std::vector<std::string>& columns, const std::string& file) {
  std::vector<std::size_t> found;
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (theirs == columns[c] || theirs == file + ":" + columns[c]) found.push_back(c);
  if (found.size() == 1) return found.front();
  throw InputError("--column", fmt::format("{} columns {}", found.size(), inQuotes(theirs)), "one",
                   found.empty() ? suggestion(theirs, columns) : "give each column a name of its own");
}

}  // namespace

tubesheets::TubeTable tubeTableBy(const std::vector<std::string>& columns, const std::string& text,
                                  const std::string& file) {
  auto table = tubesheets::parseTubeText(text);
  if (table.problem) refuseText(file, *table.problem);
  std::vector<ChosenTubeColumn> chosen;
  for (const std::string& column : columns) {
    const std::size_t equals = column.find('=');
    if (equals == std::string::npos) throw InputError("--column", inQuotes(column), "NAME=COLUMN, such as row=Reihe");
    chosen.push_back(quantityOf(column.substr(0, equals)));
    chosen.back().place = placeOfChosen(column.substr(equals + 1), table.columns, file);
  }
  return tubesheets::tubeTableOf(std::move(table), chosen);
}

}  // namespace tubeplan::app
