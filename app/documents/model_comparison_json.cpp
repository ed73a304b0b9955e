#include "app/documents/model_comparison_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/error_figures.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/step_table_json.hpp"
#include "app/files/units_json.hpp"
#include "app/studies/model/ladder_steps.hpp"

namespace tubeplan::app {

namespace {

std::string stepsHeading(std::size_t counts, const Units& units) {
  std::string text = fmt::format("{:<34}", "model");
  for (std::size_t k = 0; k < counts; ++k) text += fmt::format(" {:>9}", k == 0 ? "0 steps" : std::to_string(k));
  return text + fmt::format(" {:>9} {:>9}   holes by number of inserted steps; centring error in {}\n", "median",
                            "95 %", units.length().name);
}

std::string stepsText(const std::vector<ModelComparisonRow>& comparison, const Units& units) {
  std::string text;
  std::size_t counts = 0;
  for (const auto& compared : comparison) {
    if (!compared.steps) continue;
    counts = std::max(counts, compared.steps->counts.size());
    text += fmt::format("{:<34}", compared.name);
    for (const int count : compared.steps->counts) text += fmt::format(" {:>9}", count);
    if (compared.steps->holes > 0)
      text += fmt::format(" {:>9.4g} {:>9.4g}", compared.steps->median_error / units.factor(dimension::kLength),
                          compared.steps->p95_error / units.factor(dimension::kLength));
    if (!compared.steps->reason.empty()) text += "  none: " + compared.steps->reason;
    if (compared.steps->no_posture > 0) text += fmt::format("  ({} of them not reached)", compared.steps->no_posture);
    text += "\n";
  }
  return text.empty() ? "" : stepsHeading(counts, units) + text;
}

/// The unit that the errors of models are in: they are of the same readings.
ErrorUnit errorUnitOf(const std::vector<ModelComparisonRow>& comparison, const Units& units) {
  return errorUnitOf(!comparison.empty() && comparison.front().fitted.are_angles, units);
}

/// What the last model takes from the error of the first.
calibration::ErrorBudget budgetOf(const std::vector<ModelComparisonRow>& comparison) {
  if (comparison.empty()) return {};
  const auto &first = comparison.front(), &last = comparison.back();
  return calibration::errorBudget({first.heldout, last.heldout}, {first.fitted, last.fitted}, last.noise_floor);
}

/// "1.6 times the noise floor of 0.0057 in".
std::string overFloorText(const ModelComparisonRow& model, const ErrorUnit& unit) {
  constexpr int kDigits = 3;
  if (!(model.noise_floor > 0)) return "no noise is stated";
  return fmt::format("{:.2g} times the noise floor of {}", model.heldout.rms / model.noise_floor,
                     errorText(model.noise_floor, unit, kDigits));
}

}  // namespace

std::string modelComparisonSentence(const std::vector<ModelComparisonRow>& comparison, const Units& units) {
  constexpr int kDigits = 3;
  const ErrorUnit unit = errorUnitOf(comparison, units);
  const ModelComparisonRow* best = bestRow(comparison);
  if (!best) return "No model could be judged on held-out readings.";
  const std::string error = errorText(best->heldout.rms, unit, kDigits);
  if (comparison.size() == 1)
    return fmt::format("The held-out error of {} is {}, {}.", best->name, error, overFloorText(*best, unit));
  return fmt::format("Of {} models {} predicts held-out readings best: its error is {}, {}.", comparison.size(),
                     best->name, error, overFloorText(*best, unit));
}

nlohmann::json modelComparisonJson(const std::vector<ModelComparisonRow>& comparison, std::size_t set_aside,
                                   const Units& units) {
  const ErrorUnit unit = errorUnitOf(comparison, units);
  nlohmann::json json = {{"units", unitsJson(units)}, {"error_unit", unit.name}, {"models", nlohmann::json::array()}};
  json["error_budget"] = errorBudgetJson(budgetOf(comparison), set_aside, units);
  for (const auto& compared : comparison) {
    json["models"].push_back({{"name", compared.name},
                              {"fitted_numbers", compared.fitted_numbers},
                              {"rms",
                               {{"as_it_stands", errorJson(compared.as_it_stands.rms, unit)},
                                {"fitted", errorJson(compared.fitted.rms, unit)},
                                {"heldout", errorJson(compared.heldout.rms, unit)},
                                {"noise_floor", errorJson(compared.noise_floor, unit)}}},
                              {"mean",
                               {{"as_it_stands", errorJson(compared.as_it_stands.mean, unit)},
                                {"fitted", errorJson(compared.fitted.mean, unit)},
                                {"heldout", errorJson(compared.heldout.mean, unit)}}},
                              {"worst",
                               {{"as_it_stands", errorJson(compared.as_it_stands.max, unit)},
                                {"fitted", errorJson(compared.fitted.max, unit)},
                                {"heldout", errorJson(compared.heldout.max, unit)}}},
                              {"chi2_per_dof", compared.chi2_per_dof},
                              {"p_value", finiteJson(compared.p_value)}});
    if (!compared.steps) continue;
    json["models"].back()["steps"] = stepTableJson(*compared.steps, units);
    if (!compared.steps->reason.empty()) json["models"].back()["no_steps"] = compared.steps->reason;
  }
  return json;
}

std::string modelComparisonText(const std::vector<ModelComparisonRow>& comparison, const Units& units) {
  const auto figure = [](double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : std::string("none");
  };
  const ErrorUnit unit = errorUnitOf(comparison, units);
  const auto length = [&](double error) { return figure(error / unit.factor, 4); };
  double largest = 0;
  for (const auto& compared : comparison)
    if (std::isfinite(compared.heldout.rms)) largest = std::max(largest, compared.heldout.rms);
  std::string text = fmt::format("{:<34} {:>9} {:>9} {:>9} {:>9} {:>8}   rms, {}\n", "model", "stands", "fitted",
                                 "held out", "noise", "chi2/dof", unit.name);
  for (const auto& compared : comparison) {
    const int bar = largest > 0 && std::isfinite(compared.heldout.rms)
                        ? static_cast<int>(std::lround(40 * compared.heldout.rms / largest))
                        : 0;
    text += fmt::format("{:<34} {:>9} {:>9} {:>9} {:>9} {:>8}   {}\n", compared.name, length(compared.as_it_stands.rms),
                        length(compared.fitted.rms), length(compared.heldout.rms), length(compared.noise_floor),
                        figure(compared.chi2_per_dof, 3), std::string(static_cast<std::size_t>(bar), '#'));
  }
  return text + stepsText(comparison, units);
}

}  // namespace tubeplan::app
