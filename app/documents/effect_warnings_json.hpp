// Warnings about the effects in a cell's model, as JSON and as sentences.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/effect_warnings.hpp"

namespace tubeplan::app {

/// Returns a warning as a sentence such as "backlash@tool.z: the measurements do not need it (...): take it out".
[[nodiscard]] std::string warningText(const calibration::EffectWarning& warning, const Units& units);

/// Returns the warnings as sentences, in the order of the warnings. Similar warnings share a sentence that names all
/// effects concerned, at the place of the first of them.
[[nodiscard]] std::vector<std::string> warningTexts(const std::vector<calibration::EffectWarning>& warnings,
                                                    const Units& units);

/// Returns one entry for each warning: [{effect, at, kind, sentence, ...}, ...].
[[nodiscard]] nlohmann::json effectWarningsJson(const std::vector<calibration::EffectWarning>& warnings,
                                                const Units& units);

}  // namespace tubeplan::app
