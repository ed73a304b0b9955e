#include "app/documents/measurement_checks_json.hpp"

#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/formats/units_json.hpp"

namespace tubeplan::app {

using calibration::CheckSeverity, calibration::MeasurementCheck, calibration::MeasurementChecks;

namespace {

const char* severityName(CheckSeverity severity) { return severity == CheckSeverity::kMistake ? "mistake" : "remark"; }

nlohmann::json orNull(const std::string& text) { return text.empty() ? nlohmann::json() : nlohmann::json(text); }

nlohmann::json checkJson(const MeasurementCheck& check, const Units& units) {
  return {{"name", check.name},
          {"severity", severityName(check.severity)},
          {"sentence", check.sentence},
          {"error_as_is", lengthJson(check.error_as_is, units)},
          {"error_if_mended", lengthJson(check.error_if_corrected, units)},
          {"assume", orNull(check.assume)},
          {"equally", check.equally}};
}

constexpr TextLine kCorrectedWords[] = {
    {"error_if_mended", "; corrected, the error falls from {error_as_is:.4r units/length} to {:.4r units/length}"}};
constexpr TextLine kCheckWords[] = {{"", "{sentence}"},
                                    {"error_as_is", "", kCorrectedWords},
                                    {"assume", " (--assume {})"},
                                    {"equally", ", or equally --assume {}"}};
constexpr TextLine kCheckLine[] = {{"", "", kCheckWords}, {"", "\n"}};
constexpr TextLine kWarningWords[] = {{"warnings", "  warning: {}\n"}};
constexpr TextLine kChecksWords[] = {{"checks", "  {severity}: ", kCheckLine}};

}  // namespace

void addChecks(const MeasurementChecks& checks, const Units& units, nlohmann::json& document) {
  document["checks"] = nlohmann::json::array();
  for (const auto& check : checks.checks) document["checks"].push_back(checkJson(check, units));
  document["missing_columns"] = nlohmann::json::array();
  for (const auto& [column, sentence] : checks.missing)
    document["missing_columns"].push_back({{"column", column}, {"sentence", sentence}});
}

std::string checkText(const MeasurementCheck& check, const Units& units) {
  nlohmann::json figures = checkJson(check, units);
  figures["units"] = unitsJson(units);
  return textOf(figures, kCheckWords);
}

std::string checksText(const MeasurementChecks& checks, const Units& units) {
  nlohmann::json figures = {{"units", unitsJson(units)}};
  addChecks(checks, units, figures);
  return textOf(figures, kChecksWords);
}

std::string warningsText(const std::vector<std::string>& warnings) {
  return textOf(nlohmann::json{{"warnings", warnings}}, kWarningWords);
}

std::string mistakeText(const MeasurementChecks& checks, const Units& units) {
  const auto* mistake = calibration::firstMistake(checks);
  return mistake ? checkText(*mistake, units) : "";
}

std::string noVerdictSentence(const std::string& reason) {
  return "No verdict is possible: " + reason + (reason.ends_with('?') ? "" : ".");
}

std::vector<std::string> warningsWithChecks(const MeasurementChecks& checks, std::vector<std::string> warnings,
                                            const Units& units) {
  std::vector<std::string> all;
  for (const auto& check : checks.checks)
    if (check.severity == CheckSeverity::kMistake ||
        (check.name != "base-from-nominal" && check.name != "few-readings"))
      all.push_back(checkText(check, units));
  all.insert(all.end(), warnings.begin(), warnings.end());
  return all;
}

}  // namespace tubeplan::app
