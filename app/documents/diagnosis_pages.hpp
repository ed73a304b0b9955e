// The pages of `compare --report`, `diagnose --report` and `improve --report`.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/measurements/reading_input.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// `figures`: as `--json` writes them.
[[nodiscard]] std::string comparisonPage(const CellReadings& input, std::uint64_t seed, const nlohmann::json& figures);
/// `tested`: what the pattern search made of the refit's errors, as in the comparison's figures; may be empty.
[[nodiscard]] std::string diagnosisPage(const CellReadings& input, std::uint64_t seed, const nlohmann::json& figures,
                                        const nlohmann::json& tested);
/// The models, and of each step the errors with what was added, or with what would be closest.
[[nodiscard]] std::string improvementPage(const CellReadings& input, std::uint64_t seed, const Improvement& result);

}  // namespace tubeplan::app
