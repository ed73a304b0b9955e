// Fraction of a user formula that effects of the catalogue already explain, as JSON and as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "calibration/diagnosis/causes/formula_overlap.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json overlapJson(const std::vector<calibration::FormulaOverlap>& overlaps);

[[nodiscard]] std::string overlapText(const std::vector<calibration::FormulaOverlap>& overlaps);

}  // namespace tubeplan::app
