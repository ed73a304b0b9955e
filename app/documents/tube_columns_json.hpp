// What the columns of a table seem to be as those of a work list, for a dialog that asks.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Returns {tables, targets, options, needs, states, is_understood}: as foreignColumnsJson() has them, of one table.
/// `needs`: lists of quantities of which one list must be there. `states`: "tubes" where the headings name a tube,
/// "joints" where they name joints of the arm, else "neither". `is_understood`: its headings need no choice. Throws
/// InputError for a text that is no table.
[[nodiscard]] nlohmann::json tubeColumnsJson(const std::string& text, const std::string& file,
                                             const deflection::Arm& arm);

}  // namespace tubeplan::app
