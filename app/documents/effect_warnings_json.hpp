// Warnings about the effects that a cell carries, as JSON and as plain sentences.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/effect_warnings.hpp"

namespace tubeplan::app {

/// Returns "backlash@tool.z: the readings do not need it (...): take it out".
[[nodiscard]] std::string warningText(const calibration::EffectWarning& warning, const Units& units);

/// Returns one sentence for all warnings of a kind, with the effects concerned, in the order of the first.
[[nodiscard]] std::vector<std::string> warningTexts(const std::vector<calibration::EffectWarning>& warnings,
                                                    const Units& units);

/// Returns [{effect, at, kind, sentence, ...}].
[[nodiscard]] nlohmann::json effectWarningsJson(const std::vector<calibration::EffectWarning>& warnings,
                                                const Units& units);

}  // namespace tubeplan::app
