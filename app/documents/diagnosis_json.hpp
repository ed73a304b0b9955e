// Results of a diagnosis as JSON, and the text generated from this JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json diagnosisJson(const calibration::Diagnosis& result,
                                           const std::vector<calibration::Measurement>& measurements,
                                           const Units& units);

[[nodiscard]] std::string diagnosisText(const nlohmann::json& figures);

/// Returns a line of text with the `tubeplan add` command that adds the first explanation to the cell file `cell`;
/// empty if the diagnosis names none.
[[nodiscard]] std::string additionCommand(nlohmann::json figures, const std::string& cell);

}  // namespace tubeplan::app
