// HTML pages of `compare --report`, `diagnose --report` and `improve --report`.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/measurements/measurement_input.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// Returns the HTML page of a comparison. `figures` is the JSON that `compare --json` writes.
[[nodiscard]] std::string comparisonPage(const CellMeasurements& input, std::uint64_t seed,
                                         const nlohmann::json& figures);
/// Returns the HTML page of a diagnosis. `tested` holds the results of the pattern tests on the errors after the refit,
/// as in the JSON of a comparison; it may be empty.
[[nodiscard]] std::string diagnosisPage(const CellMeasurements& input, std::uint64_t seed,
                                        const nlohmann::json& figures, const nlohmann::json& tested);
/// Returns the HTML page of an improvement: a comparison of its models, and for each step the errors that remain with
/// the added cause, or with the best candidate if none was added.
[[nodiscard]] std::string improvementPage(const CellMeasurements& input, std::uint64_t seed, const Improvement& result);

}  // namespace tubeplan::app
