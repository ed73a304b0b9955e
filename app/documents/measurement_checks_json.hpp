// What looks wrong with readings, as JSON and as a few lines for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

/// Adds `checks` ([{name, severity, sentence, error_as_is, error_if_mended, assume, equally}], null where there is
/// none) and `missing_columns` ([{column, sentence}]) to a document.
void addChecks(const calibration::MeasurementChecks& checks, const Units& units, nlohmann::json& document);

/// One check as a sentence without its stop: what is suspected, the error as it is and if it were mended, and how.
[[nodiscard]] std::string checkText(const calibration::MeasurementCheck& check, const Units& units);

/// One line for each check; empty where there is none.
[[nodiscard]] std::string checksText(const calibration::MeasurementChecks& checks, const Units& units);

/// The mistake that keeps readings from telling anything of the model, by checkText(); empty where there is none. One
/// rule for all that judge a model or fit it.
[[nodiscard]] std::string mistakeText(const calibration::MeasurementChecks& checks, const Units& units);

/// The `verdict_words` over such a mistake.
inline constexpr const char* kMistakeWords = "Inconclusive: a mistake in the readings is to be mended first";

/// "No verdict is possible: REASON."
[[nodiscard]] std::string noVerdictSentence(const std::string& reason);

/// The sentences of the checks before other warnings.
[[nodiscard]] std::vector<std::string> warningsWithChecks(const calibration::MeasurementChecks& checks,
                                                          std::vector<std::string> warnings, const Units& units);

/// A line for each.
[[nodiscard]] std::string warningsText(const std::vector<std::string>& warnings);

/// Of a document's `set_aside`, once.
inline constexpr std::string_view kSetAsideWords =
    "  set aside as outliers, in no fit and no error: readings {set_aside:n} ({#set_aside})\n";

}  // namespace tubeplan::app
