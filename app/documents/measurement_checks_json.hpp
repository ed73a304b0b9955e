// Suspected mistakes in readings, as JSON and as a short text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

/// Adds `checks` ([{name, severity, sentence, error_as_is, error_if_mended, assume, equally}], null if there is none)
/// and `missing_columns` ([{column, sentence}]) to a document.
void addChecks(const calibration::MeasurementChecks& checks, const Units& units, nlohmann::json& document);

/// Returns one check as a sentence without its full stop: the suspected mistake, the error with and without it, and the
/// remedy.
[[nodiscard]] std::string checkText(const calibration::MeasurementCheck& check, const Units& units);

/// Returns one line for each check; empty if there is none.
[[nodiscard]] std::string checksText(const calibration::MeasurementChecks& checks, const Units& units);

/// Returns the mistake that makes readings useless for judging or fitting a model, by checkText(); empty if there is
/// none. Used by all such judgements.
[[nodiscard]] std::string mistakeText(const calibration::MeasurementChecks& checks, const Units& units);

/// Text of `verdict_words` if there is such a mistake.
inline constexpr const char* kMistakeWords = "Inconclusive: a mistake in the readings is to be mended first";

/// Returns "No verdict is possible: REASON."
[[nodiscard]] std::string noVerdictSentence(const std::string& reason);

/// Returns the sentences of the checks, followed by the other warnings.
[[nodiscard]] std::vector<std::string> warningsWithChecks(const calibration::MeasurementChecks& checks,
                                                          std::vector<std::string> warnings, const Units& units);

/// Returns one line for each warning.
[[nodiscard]] std::string warningsText(const std::vector<std::string>& warnings);

/// Template of the line about a document's `set_aside`, shown once.
inline constexpr std::string_view kSetAsideWords =
    "  set aside as outliers, in no fit and no error: readings {set_aside:n} ({#set_aside})\n";

}  // namespace tubeplan::app
