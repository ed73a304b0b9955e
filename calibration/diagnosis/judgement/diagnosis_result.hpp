// Result of a diagnosis: the verdict with its explanations, the ranking of single causes, and the unexplained errors.
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

/// Evidence that the measurements give for one cause.
struct RankedEffect {
  std::string effect, at;
  /// Effects at their most probable sizes if no other cause is present; empty for freed parameters.
  std::vector<deflection::Effect> effects;
  double probability = 0;    ///< total probability of all models that contain the cause
  double p_value = 1;        ///< probability that noise alone would lower chi-square as much as this cause alone does
  double fall = 0;           ///< decrease of chi-square due to the cause, to first order
  FoundNumber size;          ///< parameter of the cause that is largest relative to its standard deviation
  double kept_fraction = 0;  ///< fraction of the cause's signature that the free parameters do not absorb
  ErrorSize heldout_before, heldout_after;
};

/// Smallest size of an effect that these measurements would reveal in four of five cases.
struct DetectableEffect {
  std::string effect, at, number;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double size = 0;
  /// True if this size exceeds that on any real machine, so that these measurements cannot reveal the effect.
  bool is_beyond_plausible = false;
};

/// Errors that remain when the certain causes are included in the model.
struct Remainder {
  double probability = 0;    ///< probability that errors remain unexplained
  double size = kNotKnown;   ///< root mean square of the remaining errors over the measurements [m]
  double floor = kNotKnown;  ///< root mean square of noise and of errors that follow no variable [m]
  /// Variables that the errors follow, each with the fraction of the errors that it accounts for; largest first.
  std::vector<std::pair<std::string, double>> follows;
};

struct Diagnosis {
  Verdict verdict = Verdict::kNotRun;
  std::string reason;                     ///< reason why there is no verdict, and the data needed for one
  Identification baseline;                ///< fit of the current model with its free parameters
  std::vector<Explanation> alternatives;  ///< explanations that the verdict names, most probable first
  /// If ambiguous: the causes that are certain, unless all causes of the first alternative are.
  std::optional<Explanation> agreed;
  std::vector<Explanation> closest;  ///< most probable fitted models, regardless of the verdict
  std::vector<RankedEffect> ranking;
  std::vector<DetectableEffect> detectable;
  std::vector<std::string> not_tried;
  std::vector<int> set_aside;  ///< indices of the measurements excluded as outliers
  Remainder remainder;
  /// Analysis of repeated measurements; set only if the sole remaining error is scatter above the stated noise, which
  /// is then treated as noise.
  Repeats repeats;
  ErrorSize before, after, heldout_before, heldout_after, farthest_before;
  double noise_floor = kNotKnown;  ///< root mean square of the stated noise [m]
  /// Root-mean-square error of each coordinate [m] in excess of the stated noise, independent of all quantities that
  /// the measurements state.
  double model_error = 0;
  double chi2 = 0;  ///< chi-square of the baseline relative to the stated noise
  double p_value = kNotKnown;
  int degrees_of_freedom = 0;
  double nothing_probability = kNotKnown;  ///< probability that nothing is missing
  double nothing_criterion = kNotKnown;    ///< Explanation::criterion of the model with nothing missing
  /// Probability that the model lacks an unknown effect that depends on quantities stated by the measurements.
  double unknown_probability = kNotKnown;
  /// Probability that the model lacks an unknown effect that depends on no quantity stated by the measurements.
  double scatter_probability = kNotKnown;
  DiagnosisViews views;

  /// Returns true if the missing effect depends on no quantity that the measurements state, and so cannot be
  /// distinguished from a larger noise.
  [[nodiscard]] bool isScatterAlone() const {
    return verdict == Verdict::kUnexplained && scatter_probability > 0.5 && remainder.follows.empty();
  }
};

}  // namespace tubeplan::calibration
