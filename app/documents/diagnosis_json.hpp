// A diagnosis as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "app/files/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json diagnosisJson(const calibration::Diagnosis& result,
                                           const std::vector<calibration::Measurement>& readings, const Units& units);

}  // namespace tubeplan::app
