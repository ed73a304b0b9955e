// What an effect is, beside its name in a document: pages hold no words of effects themselves.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tubeplan::app {

/// Adds `words`, and the kinds of variables that its law hangs on as `varies_with`, to an entry about the effect or
/// freed number of that name.
void addEffectWords(const std::string& effect, nlohmann::json& entry);

}  // namespace tubeplan::app
