#include "app/documents/step_chances_json.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figures_text.hpp"
#include "app/formats/units_json.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::app {

namespace {

std::vector<std::string> countedIn(const StepChances& chances) {
  std::vector<std::string> counted{"the encoders"};
  if (!chances.base_is_exact) counted.emplace_back("the base pose");
  if (!chances.numbers_are_exact) counted.emplace_back("the arm's numbers");
  if (chances.model_error) counted.emplace_back("the model's own error");
  return counted;
}

std::vector<std::string> leftOutOf(const StepChances& chances) {
  std::vector<std::string> left_out;
  if (chances.base_is_exact) left_out.emplace_back("the base pose, which the cell states as known");
  if (chances.numbers_are_exact)
    left_out.emplace_back(
        "the arm's numbers, whose uncertainty together with this base is not known (touch holes, or `identify`)");
  if (!chances.model_error)
    left_out.emplace_back("the model's own error, which is not known (`identify` estimates it)");
  return left_out;
}

bool isByTouches(const ModelError& error) { return error.from == kByTouches; }

/// Returns the 95 % confidence interval of the model error's standard deviation [m].
std::array<double, 2> rangeOf(const ModelError& error) {
  if (error.degrees_of_freedom == 0) return {error.sigma, error.sigma};
  const double freedom = error.degrees_of_freedom;
  const auto at = [&](double tail) {
    return error.sigma * std::sqrt(freedom / calibration::chiSquareQuantile(tail, error.degrees_of_freedom));
  };
  return {at(0.025), at(0.975)};
}

constexpr TextLine kStepChanceWords[] = {
    {"reason", "no probabilities of steps: {}\n"},
    {"counted", "probabilities of steps count {counted}", {}, {}, 1},
    {"model_error", " ({value:.3r units/length} per coordinate, 95 % {range:.2i}, from {source})"},
    {"counted", "\n", {}, {}, 1},
    {"left_out", "  left out: {}\n"}};

}  // namespace

nlohmann::json stepChancesJson(const StepChances& chances, const Units& units) {
  if (!chances.reason.empty()) return {{"reason", chances.reason}};
  nlohmann::json expected = nlohmann::json::array();
  for (const double count : expectedCounts(chances)) expected.push_back(rounded(count));
  nlohmann::json json = {{"counted", countedIn(chances)},
                         {"left_out", leftOutOf(chances)},
                         {"expected_counts", expected},
                         {"model_error", nullptr}};
  if (!chances.model_error) return json;
  const auto range = rangeOf(*chances.model_error);
  json["model_error"] = {{"source", isByTouches(*chances.model_error) ? kByTouches : "cell"},
                         {"value", lengthOf(chances.model_error->sigma, units)},
                         {"range", {lengthOf(range[0], units), lengthOf(range[1], units)}}};
  return json;
}

std::string stepChancesText(const StepChances& chances, const Units& units) {
  nlohmann::json figures = stepChancesJson(chances, units);
  figures["units"] = unitsJson(units);
  return textOf(figures, kStepChanceWords);
}

nlohmann::json modelErrorJson(const ModelError& error, const Units& units) {
  nlohmann::json json = {{"sigma", lengthOf(error.sigma, units)}};
  if (error.degrees_of_freedom > 0) json["degrees_of_freedom"] = error.degrees_of_freedom;
  if (!error.from.empty()) json["from"] = error.from;
  return json;
}

}  // namespace tubeplan::app
