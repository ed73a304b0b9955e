// What a diagnosis answers: the verdict with its explanations, every cause by itself, and what is left.
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

/// One cause as the readings see it.
struct RankedEffect {
  std::string effect, at;
  std::vector<deflection::Effect> effects;  ///< as most probable, alone; none of numbers that are freed instead
  double probability = 0;                   ///< of all models that it is part of
  double p_value = 1;                       ///< of its fall of chi-square by noise, alone
  double fall = 0;                          ///< of chi-square, to first order or as fitted
  FoundNumber size;                         ///< its first or largest number
  double kept_fraction = 0;                 ///< of its signature that the free numbers do not absorb
  ErrorSize heldout_before, heldout_after;
};

/// The least size of an effect that these readings would show (in four of five cases).
struct DetectableEffect {
  std::string effect, at, number;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double size = 0;
  bool is_beyond_plausible = false;  ///< no machine has one that large: the readings cannot show it
};

/// What is left once the sure causes are in.
struct Remainder {
  double probability = 0;                               ///< that there is one
  double size = kNotKnown;                              ///< m, root mean square over the readings
  double floor = kNotKnown;                             ///< m, the same of noise and what follows nothing
  std::vector<std::pair<std::string, double>> follows;  ///< what it follows, and its share of it; largest first
};

struct Diagnosis {
  Verdict verdict = Verdict::kNotRun;
  std::string reason;                     ///< why not run, or why no verdict is possible; what would be needed
  Identification baseline;                ///< the model as it is, with what is free fitted
  std::vector<Explanation> alternatives;  ///< as the verdict says, most probable first
  std::optional<Explanation> agreed;      ///< ambiguous: the causes that are sure, where the alternatives add to them
  std::vector<Explanation> closest;       ///< the most probable models that were fitted, whatever the verdict
  std::vector<RankedEffect> ranking;
  std::vector<DetectableEffect> detectable;
  std::vector<std::string> not_tried;
  std::vector<int> set_aside;  ///< readings left out as outliers
  Remainder remainder;
  Repeats repeats;  ///< where their scatter, larger than stated, is all that is left: it counts as noise
  ErrorSize before, after, heldout_before, heldout_after, farthest_before;
  double noise_floor = kNotKnown;  ///< rms that the stated noise leaves [m]
  double model_error = 0;  ///< m, in each coordinate beyond the stated noise, that no function of the readings follows
  double chi2 = 0;         ///< of the baseline, by the stated noise
  double p_value = kNotKnown;
  int degrees_of_freedom = 0;
  double nothing_probability = kNotKnown;  ///< that nothing is missing
  double nothing_criterion = kNotKnown;    ///< Explanation::criterion of nothing missing
  double unknown_probability = kNotKnown;  ///< that something is, and no cause is part of it
  double scatter_probability = kNotKnown;  ///< the same, and it follows nothing that the readings state
  DiagnosisViews views;

  /// Whether what is missing follows nothing that the readings state: a larger noise than stated would be the same.
  [[nodiscard]] bool isScatterAlone() const {
    return verdict == Verdict::kUnexplained && scatter_probability > 0.5 && remainder.follows.empty();
  }
};

}  // namespace tubeplan::calibration
