// Adds descriptions of effects to documents, so that pages do not need their own texts.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tubeplan::app {

/// Adds `title` to the JSON entry about a freed parameter, because "EFFECT at PLACE" would not name it.
void addCauseTitle(nlohmann::json& entry);

/// Adds to the JSON entry about the effect or freed parameter `effect`: `words`, a description, and `varies_with`, the
/// kinds of variables in its law; also its title as addCauseTitle() does.
void addEffectWords(const std::string& effect, nlohmann::json& entry);

}  // namespace tubeplan::app
