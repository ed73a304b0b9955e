#include "app/files/foreign/foreign_table.hpp"

#include <fmt/format.h>

#include "app/files/foreign/foreign_heading.hpp"
#include "app/files/input_error.hpp"

namespace tubeplan::app {

ForeignTable parseForeignTable(std::string_view text, const std::string& file) {
  ForeignTable table{tubesheets::parseTextTable(text, {isUnitWord}), file};
  if (const auto& problem = table.problem)
    throw InputError(problem->line > 0 ? fmt::format("{}:{}", file, problem->line) : file, problem->found,
                     problem->expected, problem->advice);
  return table;
}

}  // namespace tubeplan::app
