// Pages of `compare --report`, `diagnose --report` and `improve --report`.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/measurements/reading_input.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// Returns the page of a comparison. `figures` is the document that `--json` writes.
[[nodiscard]] std::string comparisonPage(const CellReadings& input, std::uint64_t seed, const nlohmann::json& figures);
/// Returns the page of a diagnosis. `tested` is the pattern search of the refit's errors, as in the comparison's
/// figures; may be empty.
[[nodiscard]] std::string diagnosisPage(const CellReadings& input, std::uint64_t seed, const nlohmann::json& figures,
                                        const nlohmann::json& tested);
/// Returns the page of an improvement: the models, and for each step its errors with the added cause, or with the
/// closest candidate.
[[nodiscard]] std::string improvementPage(const CellReadings& input, std::uint64_t seed, const Improvement& result);

}  // namespace tubeplan::app
