// How much of a formula the catalogue has already, as JSON and in words.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "calibration/diagnosis/causes/formula_overlap.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json overlapJson(const std::vector<calibration::FormulaOverlap>& overlaps);

[[nodiscard]] std::string overlapText(const std::vector<calibration::FormulaOverlap>& overlaps);

}  // namespace tubeplan::app
