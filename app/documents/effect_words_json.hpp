// Descriptions of effects, added to documents next to the effects' names because pages contain no texts on effects.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tubeplan::app {

/// Adds to the JSON entry about an effect or freed parameter of this name: `words`, a description, and `varies_with`,
/// the kinds of variables in the effect's law.
void addEffectWords(const std::string& effect, nlohmann::json& entry);

}  // namespace tubeplan::app
