#include "app/documents/effect_words_json.hpp"

#include <nlohmann/json.hpp>

#include "calibration/diagnosis/causes/cause.hpp"

namespace tubeplan::app {

void addEffectWords(const std::string& effect, nlohmann::json& entry) {
  entry["words"] = calibration::causeWords(effect);
  entry["varies_with"] = calibration::causeVariables(effect);
}

}  // namespace tubeplan::app
