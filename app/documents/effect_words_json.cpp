#include "app/documents/effect_words_json.hpp"

#include <nlohmann/json.hpp>

#include "calibration/diagnosis/causes/cause.hpp"

namespace tubeplan::app {

void addCauseTitle(nlohmann::json& entry) {
  if (entry.at("effect") == calibration::kFreedNumbers)
    entry["title"] = calibration::causeTitle(calibration::kFreedNumbers, entry.at("at"));
}

void addEffectWords(const std::string& effect, nlohmann::json& entry) {
  entry["words"] = calibration::causeWords(effect, entry.value("at", std::string()));
  addCauseTitle(entry);
  entry["varies_with"] = calibration::causeVariables(effect);
}

}  // namespace tubeplan::app
