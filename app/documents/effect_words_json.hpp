// Description of an effect next to its name in a document, because pages hold no words of effects.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tubeplan::app {

/// Adds to an entry about the effect or freed number of that name its `words`, and as `varies_with` the kinds of
/// variables in its law.
void addEffectWords(const std::string& effect, nlohmann::json& entry);

}  // namespace tubeplan::app
