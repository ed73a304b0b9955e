// A diagnosis as JSON, and that in words.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json diagnosisJson(const calibration::Diagnosis& result,
                                           const std::vector<calibration::Measurement>& readings, const Units& units);

[[nodiscard]] std::string diagnosisText(const nlohmann::json& figures);

/// The command that adds the first explanation to the cell of this path; empty where none is sure.
[[nodiscard]] std::string additionCommand(nlohmann::json figures, const std::string& cell);

}  // namespace tubeplan::app
