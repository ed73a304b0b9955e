#include "app/documents/error_figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/storage/count_text.hpp"
#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::app {

using calibration::ErrorBudget;

ErrorUnit errorUnitOf(bool are_angles, const Units& units) {
  if (are_angles) return {std::string(units.angle().name), calibration::kTurnLever * units.factor(dimension::kAngle)};
  return {std::string(units.length().name), units.factor(dimension::kLength)};
}

nlohmann::json errorJson(double error, const ErrorUnit& unit) { return finiteJson(error / unit.factor); }

std::string errorText(double error, const ErrorUnit& unit, int digits) {
  return figureText(error / unit.factor, unit.name, digits);
}

ErrorUnit errorUnitOf(const calibration::Measurement& measurement, const Units& units) {
  return errorUnitOf(calibration::measureOnlyAngles({measurement}), units);
}

nlohmann::json errorSizeJson(const calibration::Measurement& measurement, const Eigen::Vector3d& error_W, double turn,
                             const Units& units) {
  const double size = calibration::measureOnlyAngles({measurement}) ? calibration::kTurnLever * turn : error_W.norm();
  return errorJson(size, errorUnitOf(measurement, units));
}

ErrorBudget budgetOf(const calibration::Diagnosis& result) {
  return calibration::errorBudget({result.heldout_before, result.heldout_after}, {result.before, result.after},
                                  result.noise_floor);
}

ErrorBudget budgetOf(const calibration::Comparison& result) {
  return calibration::errorBudget({result.refit.heldout_before, result.refit.heldout},
                                  {result.as_it_stands.errors, result.after_refit.errors},
                                  result.after_refit.noise_floor);
}

ErrorBudget budgetOf(const calibration::Identification& result) {
  return calibration::errorBudget({result.heldout_before, result.heldout}, {result.before, result.after},
                                  result.noise_floor);
}

nlohmann::json errorBudgetJson(const ErrorBudget& budget, std::size_t set_aside, const Units& units) {
  if (!std::isfinite(budget.total)) return nullptr;
  const ErrorUnit unit = errorUnitOf(budget.are_angles, units);
  return {{"of", budget.is_held_out ? "held-out" : "fitted"},
          {"unit", unit.name},
          {"total", errorJson(budget.total, unit)},
          {"explained", errorJson(budget.explained, unit)},
          {"remainder", errorJson(budget.remainder, unit)},
          {"noise", errorJson(budget.noise, unit)},
          {"readings", budget.measurements},
          {"set_aside", set_aside},
          {"words", errorBudgetText(budget, set_aside, units)}};
}

std::string errorBudgetText(const ErrorBudget& budget, std::size_t set_aside, const Units& units) {
  if (!std::isfinite(budget.total)) return "";
  constexpr int kDigits = 3;
  const ErrorUnit unit = errorUnitOf(budget.are_angles, units);
  const auto text = [&](double error) { return errorText(error, unit, kDigits); };
  const std::string aside =
      set_aside == 0 ? "" : fmt::format(", {} set aside as {}", set_aside, set_aside == 1 ? "an outlier" : "outliers");
  const std::string total =
      fmt::format("{} error {} (root mean square over {}{})", budget.is_held_out ? "Held-out" : "Fitted",
                  text(budget.total), countText(budget.measurements, "reading"), aside);
  if (budget.explained < 0)
    return fmt::format("{}: the fit does not lower it, and leaves {} beyond the noise of {}.", total,
                       text(budget.remainder), text(budget.noise));
  return fmt::format("{}: explained {}, remainder {}, noise {}; their squares add up.", total, text(budget.explained),
                     text(budget.remainder), text(budget.noise));
}

}  // namespace tubeplan::app
