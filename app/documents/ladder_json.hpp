// Comparison of several models on the same measurements (a ladder), with step tables, as JSON, as text and as a page.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/studies/model/ladder_steps.hpp"

namespace tubeplan::app {

/// Returns the JSON that `tubeplan ladder --json` writes. The entry `step_table` is {real_arm, unmodelled_sigma, holes,
/// out_of_reach, seed}, or {reason} if there are no step tables.
[[nodiscard]] nlohmann::json ladderJson(const std::vector<ModelComparisonRow>& comparison, const LadderSteps& steps,
                                        const std::vector<std::string>& set_aside, std::uint64_t seed,
                                        const Units& units);

/// Returns the text of the comparison, generated from the JSON of ladderJson().
[[nodiscard]] std::string ladderText(const nlohmann::json& figures);

/// Converts the models in the JSON of a comparison to the form from which the page draws them.
[[nodiscard]] nlohmann::json ladderModels(const nlohmann::json& compared_models);

/// Returns the HTML page of `ladder --report`.
[[nodiscard]] std::string ladderPage(const nlohmann::json& figures, const std::string& measurements,
                                     std::uint64_t seed);

}  // namespace tubeplan::app
