#include "app/documents/step_chances_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

namespace tubeplan::app {

namespace {

std::vector<std::string> countedIn(const StepChances& chances) {
  std::vector<std::string> counted{"the encoders"};
  if (!chances.base_is_exact) counted.emplace_back("the base pose");
  if (chances.error.source != calibration::ModelErrorSource::kLeftOut) counted.emplace_back("the model's own error");
  return counted;
}

std::vector<std::string> leftOutOf(const StepChances& chances) {
  std::vector<std::string> left_out;
  if (chances.base_is_exact) left_out.emplace_back("the base pose, which the cell states as known");
  if (chances.error.source == calibration::ModelErrorSource::kLeftOut)
    left_out.emplace_back("the model's own error, which has not been measured (touch holes, or `identify`)");
  return left_out;
}

}  // namespace

nlohmann::json stepChancesJson(const StepChances& chances, const Units& units) {
  if (!chances.reason.empty()) return {{"reason", chances.reason}};
  nlohmann::json expected = nlohmann::json::array();
  for (const double count : expectedCounts(chances)) expected.push_back(rounded(count));
  nlohmann::json json = {{"counted", countedIn(chances)},
                         {"left_out", leftOutOf(chances)},
                         {"expected_counts", expected},
                         {"model_error", nullptr}};
  if (chances.error.source == calibration::ModelErrorSource::kLeftOut) return json;
  json["model_error"] = {
      {"source", chances.error.source == calibration::ModelErrorSource::kTouches ? kByTouches : "cell"},
      {"value", lengthOf(chances.error.model_error, units)},
      {"range", {lengthOf(chances.error.lower, units), lengthOf(chances.error.upper, units)}}};
  return json;
}

std::string stepChancesText(const StepChances& chances, const Units& units) {
  if (!chances.reason.empty()) return "no probabilities of steps: " + chances.reason + "\n";
  std::string text = fmt::format("probabilities of steps count {}", fmt::join(countedIn(chances), ", "));
  if (chances.error.source != calibration::ModelErrorSource::kLeftOut)
    text += fmt::format(" (median {:.3g} {} per coordinate, 95 % {:.2g} to {:.2g}, {})",
                        lengthOf(chances.error.model_error, units), units.length().name,
                        lengthOf(chances.error.lower, units), lengthOf(chances.error.upper, units),
                        chances.error.source == calibration::ModelErrorSource::kTouches
                            ? fmt::format("as estimated from the {} touches", chances.touches)
                            : "from what the cell states");
  text += "\n";
  for (const auto& left_out : leftOutOf(chances)) text += "  left out: " + left_out + "\n";
  return text;
}

nlohmann::json modelErrorJson(const ModelError& error, const Units& units) {
  nlohmann::json json = {{"sigma", lengthOf(error.sigma, units)}};
  if (error.degrees_of_freedom > 0) json["degrees_of_freedom"] = error.degrees_of_freedom;
  if (!error.from.empty()) json["from"] = error.from;
  return json;
}

}  // namespace tubeplan::app
