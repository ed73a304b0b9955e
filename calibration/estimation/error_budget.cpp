#include "calibration/estimation/error_budget.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {

namespace {

double signedRoot(double square) { return std::copysign(std::sqrt(std::abs(square)), square); }

bool areKnown(const ErrorsBeforeAndAfter& errors) {
  return std::isfinite(errors.before.rms) && std::isfinite(errors.after.rms);
}

}  // namespace

ErrorBudget errorBudget(const ErrorsBeforeAndAfter& held_out, const ErrorsBeforeAndAfter& fitted, double noise_floor) {
  ErrorBudget budget;
  budget.is_held_out = areKnown(held_out);
  const ErrorsBeforeAndAfter& errors = budget.is_held_out ? held_out : fitted;
  if (!areKnown(errors)) return budget;
  const double before = errors.before.rms, after = errors.after.rms;
  budget.total = before;
  budget.explained = signedRoot(before * before - after * after);
  budget.noise = std::isfinite(noise_floor) ? std::min(noise_floor, after) : 0;
  budget.remainder = std::sqrt(std::max(0., after * after - budget.noise * budget.noise));
  budget.measurements = errors.after.measurements;
  budget.are_angles = errors.after.are_angles;
  return budget;
}

bool measureOnlyAngles(const std::vector<Measurement>& measurements) {
  return !measurements.empty() && std::ranges::all_of(measurements, [](const Measurement& measurement) {
    return kindOf(measurement).turn_rows >= kindOf(measurement).rows;
  });
}

}  // namespace tubeplan::calibration
