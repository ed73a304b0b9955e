// Judgement after an alarm: which of the candidate changes explain the measurements since then, and which of these the
// measurements cannot distinguish.
//
// Every candidate is fitted as a step and as a ramp from each likely start. With counts of steps, the start is then
// moved to where the fit explains the measurements best. A candidate's gain is the decrease of the deviance against no
// change. A candidate is one of the answers unless the largest gain exceeds its gain by more than chance allows, for
// the numbers that the other has in addition and the number of candidates (likelihood ratio test, Bonferroni). The
// answers are ranked by their probabilities: the prior, times the evidence by Laplace's approximation, which charges
// each number for the range that it could have had.
#pragma once

#include "calibration/watch/change_fit.hpp"

namespace tubeplan::calibration {

struct AnsweredNumber {
  std::string name;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double value = 0, sigma = 0;  ///< change [internal units]; an infinite `sigma`: not determined by the measurements
  double fitted = 0, fitted_sigma = 0;  ///< `value` and `sigma` in units of ChangeNumber::typical
};

/// A change that explains the measurements.
struct ChangeAnswer {
  int candidate = 0;  ///< index into CandidateChanges::list
  std::string effect, at;
  Remedy remedy = Remedy::kRemeasureArm;
  bool may_be_step = false, may_be_ramp = false;
  int since = 0;           ///< first measurement after the change, for the better course
  double gain = 0;         ///< decrease of -2 log posterior density against no change
  double probability = 0;  ///< posterior probability among all candidates
  std::vector<AnsweredNumber> numbers;
  double most_shift = 0;  ///< largest shift of the measured point at the measurements since the change [m]
  std::string assumed;    ///< unstated condition that must have changed; empty if there is none
};

struct ChangeJudgement {
  bool is_explained = false;          ///< true if at least one candidate leaves only noise
  std::vector<ChangeAnswer> answers;  ///< indistinguishable answers, most probable first; empty if none explains
  int tried = 0;                      ///< number of candidates tried
  double p_value = 1;                 ///< p-value of the best candidate's residuals of the measured values
  /// Displacement of the base that explains the measurements best.
  std::vector<AnsweredNumber> base;
};

/// Judges the candidates by the measurements up to `last`. `states` are the filter's states before each measurement;
/// `starts` are the measurements tried as the first one after the change, the likeliest first. With counts, only
/// the candidates near the best at the first start are tried at the other starts.
[[nodiscard]] ChangeJudgement judgeChange(const RowsAndCandidates& watched, const std::vector<ErrorState>& states,
                                          const std::vector<int>& starts, int last, const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
