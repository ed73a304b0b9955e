// Warnings about the effects in a cell's model, as JSON and as sentences.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/effect_warnings.hpp"

namespace tubeplan::app {

/// Returns a warning as a sentence such as "backlash@tool.z: the readings do not need it (...): take it out".
[[nodiscard]] std::string warningText(const calibration::EffectWarning& warning, const Units& units);

/// Returns the warnings as sentences; similar warnings share a sentence that names all effects concerned. The sentences
/// are in the order of their first warnings.
[[nodiscard]] std::vector<std::string> warningTexts(const std::vector<calibration::EffectWarning>& warnings,
                                                    const Units& units);

/// Returns [{effect, at, kind, sentence, ...}, ...].
[[nodiscard]] nlohmann::json effectWarningsJson(const std::vector<calibration::EffectWarning>& warnings,
                                                const Units& units);

}  // namespace tubeplan::app
