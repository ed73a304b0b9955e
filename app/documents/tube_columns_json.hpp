// Probable meanings of the columns in a table that may be a work list, for the dialog in which the user confirms them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Returns {tables, targets, options, needs, states, is_understood}; the first three are as in foreignColumnsJson(),
/// for one table. `needs` has alternative lists of required quantities. `states` is "tubes" if the headings name a
/// tube, "joints" if they name joints of the arm, else "neither". `is_understood` is true if the user need not choose
/// columns. Throws InputError if `text` is not a table.
[[nodiscard]] nlohmann::json tubeColumnsJson(const std::string& text, const std::string& file,
                                             const deflection::Arm& arm);

}  // namespace tubeplan::app
