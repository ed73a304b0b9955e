// Ladder of models with its step table as JSON, in words and as a page.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/studies/model/ladder_steps.hpp"

namespace tubeplan::app {

/// Returns the document that `tubeplan ladder --json` writes; for the steps {real_arm, unmodelled_sigma, holes,
/// out_of_reach, seed}, or {reason}.
[[nodiscard]] nlohmann::json ladderJson(const std::vector<ModelComparisonRow>& comparison, const LadderSteps& steps,
                                        const std::vector<std::string>& set_aside, std::uint64_t seed,
                                        const Units& units);

/// Returns the ladder in words, from its JSON.
[[nodiscard]] std::string ladderText(const nlohmann::json& figures);

/// Returns the models of a ladder in the form that its page draws, from those of its figures.
[[nodiscard]] nlohmann::json ladderModels(const nlohmann::json& compared_models);

/// Returns the page of --report.
[[nodiscard]] std::string ladderPage(const nlohmann::json& figures, const std::string& measurements,
                                     std::uint64_t seed);

}  // namespace tubeplan::app
