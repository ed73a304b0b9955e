// The pages of `compare --report` and `diagnose --report`.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/files/reading_input.hpp"

namespace tubeplan::app {

/// `figures`: as `--json` writes them.
[[nodiscard]] std::string comparisonPage(const CellReadings& input, std::uint64_t seed, const nlohmann::json& figures);
[[nodiscard]] std::string diagnosisPage(const CellReadings& input, std::uint64_t seed, const nlohmann::json& figures);

}  // namespace tubeplan::app
