#include "app/files/foreign/foreign_table.hpp"

#include <fmt/format.h>

#include "app/files/foreign/foreign_heading.hpp"
#include "app/files/foreign/pointing_table.hpp"
#include "app/files/input_error.hpp"

namespace tubeplan::app {

bool isBlankField(std::string_view field) {
  return field.empty() || field == "-" || field == "--" || field == "NaN" || field == "nan" || field == "n/a" ||
         field == "N/A";
}

ForeignTable parseForeignTable(std::string_view text, const std::string& file) {
  if (isPointingData(text)) return parsePointingData(text, file);
  ForeignTable table{
      tubesheets::parseTextTable(text, {.isUnit = isUnitWord, .statesUnits = statesUnits}), file, {}, {}};
  if (const auto& problem = table.problem)
    throw InputError(problem->line > 0 ? fmt::format("{}:{}", file, problem->line) : file, problem->found,
                     problem->expected, problem->advice);
  table.units = statedUnits(table.lines_before, file);
  return table;
}

}  // namespace tubeplan::app
