// What a user says that the columns of a work list are: "row=Reihe", "x_mm=list.csv:Lage".
#pragma once

#include <string>
#include <vector>

#include "tubesheets/tube_table.hpp"

namespace tubeplan::app {

/// Returns the list's table with those columns and no others; `file` is its name. Throws InputError for a text that is
/// no table, for a quantity that lists have not and for a column that is not there or there twice.
[[nodiscard]] tubesheets::TubeTable tubeTableBy(const std::vector<std::string>& columns, const std::string& text,
                                                const std::string& file);

}  // namespace tubeplan::app
