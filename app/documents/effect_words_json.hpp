// Descriptions of effects, added to documents next to the effects' names, so that pages need not contain them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tubeplan::app {

/// Adds to the JSON entry about the effect or freed parameter `effect`: `words`, a description, and `varies_with`, the
/// kinds of variables in its law.
void addEffectWords(const std::string& effect, nlohmann::json& entry);

}  // namespace tubeplan::app
