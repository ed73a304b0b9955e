#include "app/documents/model_comparison_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/error_figures.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/step_table_json.hpp"
#include "app/formats/units_json.hpp"
#include "app/studies/model/ladder_steps.hpp"

namespace tubeplan::app {

namespace {

constexpr TextLine kStepCountWords[] = {
    {"centring_error", " {median:>9.4r} {p95:>9.4r}"}, {"no_posture", "  ({} of them not reached)"}, {"", "\n"}};

constexpr TextLine kModelWords[] = {
    {"", "model                                 stands    fitted  held out     noise chi2/dof   rms, {error_unit}\n"},
    {"models",
     "{name:<34} {rms/as_it_stands:>9.4r} {rms/fitted:>9.4r} {rms/heldout:>9.4r} {rms/noise_floor:>9.4r} "
     "{chi2_per_dof:>8.3r}   {bar}\n"},
    {"models/steps",
     "model                              holes by number of inserted steps, from none; median and 95 % of the centring "
     "error, {units/length}\n",
     {},
     {},
     1},
    {"models/steps", "{name:<34}{counts:*10}", kStepCountWords},
    {"models/no_steps", "{name:<34}  none: {}\n"}};

/// Returns the unit in which the models' errors are written; all models are compared on the same measurements.
ErrorUnit errorUnitOf(const std::vector<ModelComparisonRow>& comparison, const Units& units) {
  return errorUnitOf(!comparison.empty() && comparison.front().fitted.are_angles, units);
}

/// Returns the error budget of the comparison: the error of the first model, and the part that the last model explains.
calibration::ErrorBudget budgetOf(const std::vector<ModelComparisonRow>& comparison) {
  if (comparison.empty()) return {};
  const auto &first = comparison.front(), &last = comparison.back();
  return calibration::errorBudget({first.heldout, last.heldout}, {first.fitted, last.fitted}, last.noise_floor);
}

/// Returns a string such as "1.6 times the noise floor of 0.0057 in".
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

std::string modelComparisonText(nlohmann::json figures) {
  constexpr double kLongestBar = 40;
  double largest = 0;
  const auto error = [](const nlohmann::json& model) {
    return model["rms"]["heldout"].is_null() ? 0 : model["rms"]["heldout"].get<double>();
  };
  for (const auto& model : figures["models"]) largest = std::max(largest, error(model));
  for (auto& model : figures["models"]) {
    const double share = largest > 0 ? error(model) / largest : 0;
    model["bar"] = std::string(static_cast<std::size_t>(std::lround(kLongestBar * share)), '#');
  }
  return textOf(figures, kModelWords);
}

}  // namespace tubeplan::app
