// Fraction of a user formula's contribution that the other fitted parameters and effects of the catalogue can
// reproduce, as JSON and as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "calibration/diagnosis/causes/formula_overlap.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json overlapJson(const std::vector<calibration::FormulaOverlap>& overlaps);

[[nodiscard]] std::string overlapText(const std::vector<calibration::FormulaOverlap>& overlaps);

}  // namespace tubeplan::app
