#include "app/documents/measurement_checks_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/files/input_error.hpp"

namespace tubeplan::app {

using calibration::CheckSeverity, calibration::MeasurementCheck, calibration::MeasurementChecks;

namespace {

const char* severityName(CheckSeverity severity) { return severity == CheckSeverity::kMistake ? "mistake" : "remark"; }

nlohmann::json orNull(const std::string& text) { return text.empty() ? nlohmann::json() : nlohmann::json(text); }

}  // namespace

void addChecks(const MeasurementChecks& checks, const Units& units, nlohmann::json& document) {
  document["checks"] = nlohmann::json::array();
  for (const auto& check : checks.checks)
    document["checks"].push_back({{"name", check.name},
                                  {"severity", severityName(check.severity)},
                                  {"sentence", check.sentence},
                                  {"error_as_is", lengthJson(check.error_as_is, units)},
                                  {"error_if_mended", lengthJson(check.error_if_mended, units)},
                                  {"assume", orNull(check.assume)},
                                  {"equally", check.equally}});
  document["missing_columns"] = nlohmann::json::array();
  for (const auto& [column, sentence] : checks.missing)
    document["missing_columns"].push_back({{"column", column}, {"sentence", sentence}});
}

std::string checkText(const MeasurementCheck& check, const Units& units) {
  std::string text = check.sentence;
  if (std::isfinite(check.error_as_is) && std::isfinite(check.error_if_mended))
    text += fmt::format("; corrected, the error falls from {} to {}", lengthText(check.error_as_is, units),
                        lengthText(check.error_if_mended, units));
  if (!check.assume.empty()) text += fmt::format(" (--assume {})", check.assume);
  if (!check.equally.empty()) text += fmt::format(", or equally --assume {}", fmt::join(check.equally, " or --assume "));
  return text;
}

std::string checksText(const MeasurementChecks& checks, const Units& units) {
  std::string text;
  for (const auto& check : checks.checks)
    text += fmt::format("  {}: {}\n", check.severity == CheckSeverity::kMistake ? "MISTAKE SUSPECTED" : "remark",
                        checkText(check, units));
  return text;
}

std::string mistakeText(const MeasurementChecks& checks, const Units& units) {
  const auto* mistake = calibration::grossMistake(checks);
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

std::string setAsideText(const std::vector<std::string>& ids, std::size_t readings) {
  if (ids.empty()) return "";
  std::vector<std::string> names;
  for (const std::string& id : ids) names.push_back(nameInLine(id));
  return fmt::format("  set aside as outliers: {} of {} readings ({:.2g} %): {}\n", names.size(), readings,
                     100. * static_cast<double>(names.size()) / static_cast<double>(readings), fmt::join(names, ", "));
}

}  // namespace tubeplan::app
