// Explanation of a lack of fit: the effects found, their numbers, and the errors that remain with them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct FoundNumber {
  std::string name;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double value = 0;
  double sigma = kNotKnown;      ///< NaN for a scanned shape
  bool is_beyond_usual = false;  ///< true: larger than in real machines, by more than its uncertainty
  /// Range of a size over all sizes that explain the readings, if several do; otherwise NaN.
  double lower = kNotKnown, upper = kNotKnown;
};

struct FoundEffect {
  std::string effect, at;
  deflection::Effect fitted;       ///< kind -1 for freed numbers
  std::vector<std::string> frees;  ///< numbers of the arm's file that are freed instead of an effect
  std::vector<FoundNumber> numbers;
  /// Effect and place of others that no reading could distinguish from this one.
  std::vector<std::pair<std::string, std::string>> also;
  /// Values of its numbers that explain the readings equally well, the found ones first; empty if only these do.
  std::vector<std::vector<double>> modes;
  std::vector<MeasurementKind> decided_by;  ///< kinds of measurement, one of which would decide between these modes
};

/// Model with added causes, fitted with everything that is free.
struct Explanation {
  std::vector<FoundEffect> effects;
  PlacedArm fitted;
  double probability = 0;            ///< probability of these causes and no others, with or without a remainder
  double chi2 = kNotKnown;           ///< chi-square for the stated noise
  double p_value = kNotKnown;        ///< p-value of `chi2`
  double criterion = kNotKnown;      ///< -2 log of prior times evidence; only differences are meaningful
  double remainder_probability = 0;  ///< probability that something unnamed is missing as well
  /// Error of each coordinate beyond the stated noise that no function of the readings follows [m].
  double model_error = 0;
  ErrorSize after, heldout;
  ErrorSize farthest;  ///< error at the quarter of the poses with the farthest reach, by a fit to the others
  /// Rms distance of the predicted tips from those of the first alternative over the arm's range [m].
  double apart = kNotKnown;
};

}  // namespace tubeplan::calibration
