#include "calibration/measurement_checks/rounded_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kDisplayDegrees[] = {1, 0.5, 0.1, 0.05, 0.01};                // display resolutions [deg]
constexpr double kDisplayRadians[] = {0.1, 0.05, 0.01, 0.005, 0.001, 0.0005};  // display resolutions [rad]
// Largest deviation of a reading from a multiple of the step, relative to the step, if it is written with few digits.
constexpr double kNearStep = 0.02;
constexpr std::size_t kLeastMeasurements = 8, kLeastStops = 4;
// The actual errors and those caused by rounding may differ at most by the reciprocal of this factor.
constexpr double kShareOfError = 1. / 3;

struct DisplayStep {
  double size = 0;  ///< resolution [rad]; 0 if the readings are not rounded
  std::string text;
};

/// Returns all display resolutions, largest first.
std::vector<DisplayStep> displaySteps() {
  std::vector<DisplayStep> steps;
  for (const double degrees : kDisplayDegrees) steps.push_back({degrees * kDegree, fmt::format("{} deg", degrees)});
  for (const double radians : kDisplayRadians) steps.push_back({radians, fmt::format("{} rad", radians)});
  std::ranges::sort(steps, std::greater{}, &DisplayStep::size);
  return steps;
}

/// Returns true if a joint's readings are whole multiples of a step and have several different values. A joint that
/// hardly moves may have a round value by chance.
bool areMultiples(const std::vector<Measurement>& measurements, int joint, double step) {
  std::set<double> places;
  for (const auto& measurement : measurements) {
    const double steps = measurement.q[joint] / step;
    if (std::abs(steps - std::round(steps)) >= kNearStep) return false;
    places.insert(std::round(steps));
  }
  return places.size() >= kLeastStops;
}

/// For each joint, returns the coarsest display resolution that divides all its readings; size 0 if none is coarser
/// than the encoder.
std::vector<DisplayStep> stepsOf(const CheckedMeasurements& checked) {
  const auto& arm = checked.start.arm;
  const auto steps = displaySteps();
  std::vector<DisplayStep> of_joints(static_cast<std::size_t>(arm.jointCount()));
  for (const int j : turningJoints(arm)) {
    const auto found = std::ranges::find_if(steps, [&](const DisplayStep& step) {
      return arm.joint(j).encoder_sigma < step.size / std::sqrt(12) && areMultiples(checked.measurements, j, step.size);
    });
    if (found != steps.end()) of_joints[static_cast<std::size_t>(j)] = *found;
  }
  return of_joints;
}

/// Returns the root-mean-square displacement of the tips that the rounding of the joints causes [m].
double motionOfRounding(const std::vector<DisplayStep>& steps, const MistakeTrials& trials) {
  const PlacedArm& placed = trials.asIs().placed;
  double squares = 0;
  int count = 0;
  for (const auto& measurement : trials.checked().measurements) {
    if (!statedPlace(measurement)) continue;
    const auto predicted = predictMeasurement(placed, measurement, {.by_joints = true});
    if (!predicted.ok) continue;
    for (std::size_t j = 0; j < steps.size(); ++j)
      squares +=
          predicted.by_joints.col(static_cast<Eigen::Index>(j)).squaredNorm() * steps[j].size * steps[j].size / 12;
    ++count;
  }
  return std::sqrt(squares / std::max(1, count));
}

/// Returns the fraction of the sum of squares of random scatter that remains after a fit of all open parameters; small
/// if there are few measurements.
double shareLeft(const MistakeTrials& trials) {
  double rows = 0;
  for (const auto& measurement : trials.pool().measurements)
    if (trials.pool().counted.contains(measurement.id)) rows += rowsOf(measurement);
  return std::clamp(trials.freedom({}, TrialDepth::kOpen) / std::max(1., rows), 0., 1.);
}

/// Returns a phrase such as "all joint readings are multiples of 0.1 deg", or "the readings of q1 and q2 are multiples
/// of 0.1 deg, of q3 of 0.001 rad".
std::string stepsText(const CheckedMeasurements& checked, const std::vector<DisplayStep>& steps) {
  const auto is_alike = [&](const DisplayStep& step) { return step.text == steps.front().text; };
  if (std::ranges::all_of(steps, is_alike)) return "all joint readings are multiples of " + steps.front().text;
  std::string text;
  for (const auto& step : displaySteps()) {
    std::string names;
    for (std::size_t j = 0; j < steps.size(); ++j)
      if (steps[j].text == step.text)
        names += (names.empty() ? "" : ", ") + checked.start.arm.joint(static_cast<Eigen::Index>(j)).name;
    if (names.empty()) continue;
    text += (text.empty() ? "the readings of " + names + " are multiples" : ", of " + names) + " of " + step.text;
  }
  return text;
}

}  // namespace

std::optional<MeasurementCheck> roundedJoints(const MistakeTrials& trials) {
  const CheckedMeasurements& checked = trials.checked();
  const Trial& as_is = trials.asIs();
  constexpr double kMisfit = 2;  // chi-square per degree of freedom above which the fit is inadequate
  if (checked.measurements.size() < kLeastMeasurements || !(as_is.chi2_per_freedom > kMisfit)) return std::nullopt;
  const auto steps = stepsOf(checked);
  if (std::ranges::none_of(steps, [](const DisplayStep& step) { return step.size > 0; })) return std::nullopt;
  const double motion = motionOfRounding(steps, trials);
  const double unabsorbed = motion * std::sqrt(shareLeft(trials));
  const bool is_as_large = motion > kShareOfError * as_is.open_error && as_is.open_error > kShareOfError * unabsorbed;
  if (motion < trials.noise({}) || !is_as_large) return std::nullopt;
  const auto& unit = checked.units.coordinates;
  return remarkOf("rounded-joints", fmt::format("{}: if they were rounded to it, that alone moves the tip by about "
                                                "{:.2g} {}; record them with all digits of the controller",
                                                stepsText(checked, steps), motion / unit.factor, unit.name));
}

}  // namespace tubeplan::calibration
