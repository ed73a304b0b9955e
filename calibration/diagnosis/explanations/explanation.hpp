// Explanation of a lack of fit: the effects found, their parameters, and the errors that remain with these effects.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct FoundNumber {
  std::string name;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double value = 0;
  double sigma = kNotKnown;  ///< standard deviation of `value`; NaN for a scanned parameter
  /// True if the value exceeds the largest value found on real machines by more than its uncertainty.
  bool is_beyond_usual = false;
  /// Range of the values that explain the measurements equally well; NaN if there is only one such value.
  double lower = kNotKnown, upper = kNotKnown;
};

struct FoundEffect {
  std::string effect, at;
  deflection::Effect fitted;       ///< effect at its fitted values; kind -1 for freed parameters
  std::vector<std::string> frees;  ///< parameters of the arm's file that are freed instead of an effect
  std::vector<FoundNumber> numbers;
  /// Other causes (effect and location) that no measurement could distinguish from this one.
  std::vector<std::pair<std::string, std::string>> indistinguishable;
  /// Sets of values of the effect's parameters that explain the measurements equally well, the fitted set first; empty
  /// if there is only one set.
  std::vector<std::vector<double>> modes;
  std::vector<MeasurementKind> decided_by;  ///< kinds of measurement; any one of them would decide between the modes
};

inline constexpr double kFoundSigmas = 2;  ///< smallest fitted value that is treated as nonzero [standard deviations]

/// Returns the largest size of a found effect over its parameters [standard deviations]; 0 if none has one.
[[nodiscard]] inline double significanceOf(const FoundEffect& effect) {
  double most = 0;
  for (const FoundNumber& number : effect.numbers)
    if (number.sigma > 0) most = std::max(most, std::abs(number.value) / number.sigma);
  return most;
}

/// Model with added causes, fitted together with all free parameters.
struct Explanation {
  std::vector<FoundEffect> effects;
  PlacedArm fitted;
  double probability = 0;        ///< probability of exactly these causes, with or without an unexplained discrepancy
  double chi2 = kNotKnown;       ///< chi-square relative to the stated noise
  double p_value = kNotKnown;    ///< p-value of `chi2`
  double criterion = kNotKnown;  ///< -2 log(prior x evidence); only differences are meaningful
  double remainder_probability = 0;  ///< probability that an unknown effect is missing as well
  /// Root-mean-square error of each coordinate [m] in excess of the stated noise, independent of all quantities that
  /// the measurements state.
  double model_error = 0;
  ErrorSize after, heldout;
  /// Error at the quarter of the poses that reach farthest, predicted by a fit to the other poses.
  ErrorSize farthest;
  /// Root-mean-square distance [m] between the tips predicted by this explanation and by the first alternative, over
  /// the arm's range.
  double distance_from_first = kNotKnown;
};

}  // namespace tubeplan::calibration
