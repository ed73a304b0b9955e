// Likely meanings of a table's columns as a work list, for a dialog.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Returns {tables, targets, options, needs, states, is_understood}: as foreignColumnsJson(), for one table. `needs`:
/// alternative lists of required quantities. `states`: "tubes" if the headings name a tube, "joints" if they name
/// joints of the arm, else "neither". `is_understood`: true if the headings need no choice. Throws InputError for a
/// text that is no table.
[[nodiscard]] nlohmann::json tubeColumnsJson(const std::string& text, const std::string& file,
                                             const deflection::Arm& arm);

}  // namespace tubeplan::app
