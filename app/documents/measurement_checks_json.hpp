// Suspected mistakes in measurements, as JSON and as short text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

/// Adds to a JSON document: `checks`, [{name, severity, sentence, error_as_is, error_if_mended, assume, equally},
/// ...], and `missing_columns`, [{column, sentence}, ...]; errors and `assume` are null if there are none.
void addChecks(const calibration::MeasurementChecks& checks, const Units& units, nlohmann::json& document);

/// Returns a check as a sentence without its full stop: the suspected mistake, the error with and without the mistake,
/// and the remedy.
[[nodiscard]] std::string checkText(const calibration::MeasurementCheck& check, const Units& units);

/// Returns one line for each check; empty if there are none.
[[nodiscard]] std::string checksText(const calibration::MeasurementChecks& checks, const Units& units);

/// Returns the checkText() of a mistake that makes the measurements unusable for judging or fitting a model; empty if
/// there is none.
[[nodiscard]] std::string mistakeText(const calibration::MeasurementChecks& checks, const Units& units);

/// Value of the key `verdict_words` if the measurements contain a mistake, that is, if mistakeText() is not empty.
inline constexpr const char* kMistakeWords = "Inconclusive: a mistake in the readings must be corrected first";

/// Returns the sentence "No verdict is possible: REASON."
[[nodiscard]] std::string noVerdictSentence(const std::string& reason);

/// Returns the sentences of the checks except the remarks base-from-nominal and few-readings, followed by `warnings`.
[[nodiscard]] std::vector<std::string> warningsWithChecks(const calibration::MeasurementChecks& checks,
                                                          std::vector<std::string> warnings, const Units& units);

/// Returns one line for each warning.
[[nodiscard]] std::string warningsText(const std::vector<std::string>& warnings);

/// Text line (TextLine::words) that lists the `set_aside` measurements of a document.
inline constexpr std::string_view kSetAsideWords =
    "  set aside as outliers, in no fit and no error: readings {set_aside:n} ({#set_aside})\n";

}  // namespace tubeplan::app
