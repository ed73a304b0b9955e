// Result of a diagnosis: the verdict with its explanations, the ranking of single causes, and the remainder.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibration/diagnosis/explanations/explanation.hpp"
#include "calibration/diagnosis/judgement/diagnosis_views.hpp"
#include "calibration/diagnosis/judgement/verdict.hpp"
#include "calibration/estimation/repeats.hpp"

namespace tubeplan::calibration {

/// Evidence of the readings for one cause.
struct RankedEffect {
  std::string effect, at;
  std::vector<deflection::Effect> effects;  ///< effects at their most probable sizes, alone; empty for freed numbers
  double probability = 0;                   ///< probability of all models that contain the cause
  double p_value = 1;                       ///< p-value of the cause's fall of chi-square by noise, alone
  double fall = 0;                          ///< fall of chi-square, to first order or as fitted
  FoundNumber size;                         ///< first or largest number of the cause
  double kept_fraction = 0;                 ///< share of its signature that the free numbers do not absorb
  ErrorSize heldout_before, heldout_after;
};

/// Least size of an effect that these readings would show (in four of five cases).
struct DetectableEffect {
  std::string effect, at, number;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double size = 0;
  bool is_beyond_plausible = false;  ///< true: no machine has one that large, so the readings cannot show it
};

/// Errors that remain with the sure causes in the model.
struct Remainder {
  double probability = 0;    ///< probability of a remainder
  double size = kNotKnown;   ///< root mean square over the readings [m]
  double floor = kNotKnown;  ///< root mean square of noise and of errors that follow nothing [m]
  std::vector<std::pair<std::string, double>> follows;  ///< variables that it follows, with their shares; largest first
};

struct Diagnosis {
  Verdict verdict = Verdict::kNotRun;
  std::string reason;                     ///< reason for no run or no verdict, and what would be needed
  Identification baseline;                ///< fit of the present model with what is free
  std::vector<Explanation> alternatives;  ///< explanations that the verdict names, most probable first
  std::optional<Explanation> agreed;      ///< if ambiguous: the sure causes, if the alternatives add to them
  std::vector<Explanation> closest;       ///< most probable fitted models, whatever the verdict
  std::vector<RankedEffect> ranking;
  std::vector<DetectableEffect> detectable;
  std::vector<std::string> not_tried;
  std::vector<int> set_aside;  ///< readings left out as outliers
  Remainder remainder;
  /// Repeated readings, if their scatter above the stated noise is all that remains; it counts as noise.
  Repeats repeats;
  ErrorSize before, after, heldout_before, heldout_after, farthest_before;
  double noise_floor = kNotKnown;  ///< rms of the stated noise [m]
  /// Error of each coordinate beyond the stated noise that no function of the readings follows [m].
  double model_error = 0;
  double chi2 = 0;  ///< chi-square of the baseline, for the stated noise
  double p_value = kNotKnown;
  int degrees_of_freedom = 0;
  double nothing_probability = kNotKnown;  ///< probability that nothing is missing
  double nothing_criterion = kNotKnown;    ///< Explanation::criterion of nothing missing
  double unknown_probability = kNotKnown;  ///< probability that something is missing without any named cause
  /// Probability that something is missing and follows nothing that the readings state.
  double scatter_probability = kNotKnown;
  DiagnosisViews views;

  /// Returns true if the missing part follows nothing that the readings state, and so cannot be distinguished from a
  /// larger noise.
  [[nodiscard]] bool isScatterAlone() const {
    return verdict == Verdict::kUnexplained && scatter_probability > 0.5 && remainder.follows.empty();
  }
};

}  // namespace tubeplan::calibration
