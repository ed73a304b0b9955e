// Judgement after an alarm: which of the candidate changes explain the measurements since then, and which of these the
// measurements cannot tell apart.
//
// Every candidate is fitted as a step and as a ramp from each likely start. Its gain is the fall of the deviance
// against no change. A candidate is one of the answers unless the largest gain exceeds its own by more than chance
// allows, for the numbers that the other has in addition and the number of candidates (likelihood ratio test,
// Bonferroni). The answers are ranked by their probabilities: the prior, times the evidence by Laplace's approximation,
// which charges each number for the range that it could have had.
#pragma once

#include "calibration/watch/change_fit.hpp"

namespace tubeplan::calibration {

struct AnsweredNumber {
  std::string name;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double value = 0, sigma = 0;  ///< change [internal units]; an infinite `sigma`: not determined by the measurements
  double fitted = 0, fitted_sigma = 0;  ///< the same in units of ChangeNumber::typical
};

/// A change that explains the measurements.
struct ChangeAnswer {
  int candidate = 0;  ///< index into CandidateChanges::list
  std::string effect, at;
  Remedy remedy = Remedy::kRemeasureArm;
  bool may_be_step = false, may_be_ramp = false;
  int since = 0;           ///< first measurement after the change, for the better course
  double gain = 0;         ///< fall of -2 log posterior density against no change
  double probability = 0;  ///< among all candidates
  std::vector<AnsweredNumber> numbers;
  double most_shift = 0;  ///< largest shift of the measured point at the measurements since the change [m]
  std::string assumed;    ///< condition that the measurements do not state and that must have changed; empty: none
};

struct ChangeJudgement {
  bool is_explained = false;          ///< true: at least one candidate leaves no more than noise
  std::vector<ChangeAnswer> answers;  ///< those that cannot be told apart, most probable first; empty: none explains
  int tried = 0;                      ///< number of candidates
  double p_value = 1;                 ///< of what the best candidate leaves of the measured values
  /// Displacement of the base that explains the measurements best.
  std::vector<AnsweredNumber> base;
};

/// Judges by the measurements up to `last`. `states` are the filter's states before each measurement; `starts` are the
/// measurements that are tried as the first one after the change, the likeliest first. With counts, only the candidates
/// that the first start leaves near the best are tried at the others.
[[nodiscard]] ChangeJudgement judgeChange(const RowsAndCandidates& watched, const std::vector<ErrorState>& states,
                                          const std::vector<int>& starts, int last, const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
