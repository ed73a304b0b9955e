// What a model gains by causes that it lacked: the effects found, their numbers, and how well it then does.
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
  double sigma = kNotKnown;      ///< NaN for a shape that was scanned
  bool is_beyond_usual = false;  ///< larger than real machines have, by more than its doubt
  /// The range of a size that the readings leave open, over all sizes that explain them; else not numbers.
  double lower = kNotKnown, upper = kNotKnown;
};

struct FoundEffect {
  std::string effect, at;
  deflection::Effect fitted;       ///< kind -1 of freed numbers
  std::vector<std::string> frees;  ///< numbers of the arm's file that are freed instead of an effect
  std::vector<FoundNumber> numbers;
  std::vector<std::pair<std::string, std::string>>
      also;  ///< effect and place of others that no reading could distinguish from it
  /// Values of its numbers with which the readings are explained as well, the found ones first; empty where only these
  /// do.
  std::vector<std::vector<double>> modes;
  std::vector<MeasurementKind> decided_by;  ///< of which one reading would tell those apart
};

/// A model with causes added, fitted with everything that is free.
struct Explanation {
  std::vector<FoundEffect> effects;
  PlacedArm fitted;
  double probability = 0;            ///< of these causes and no others, with a remainder or without
  double chi2 = kNotKnown;           ///< by the stated noise
  double p_value = kNotKnown;        ///< of it
  double criterion = kNotKnown;      ///< -2 log of prior times evidence: differences count
  double remainder_probability = 0;  ///< that something unnamed is missing beside
  double model_error = 0;  ///< m, in each coordinate beyond the stated noise, that no function of the readings follows
  ErrorSize after, heldout;
  ErrorSize farthest;        ///< of the quarter of the poses that reach farthest, by a fit to the others
  double apart = kNotKnown;  ///< m, rms over the arm's range, from the first alternative
};

}  // namespace tubeplan::calibration
