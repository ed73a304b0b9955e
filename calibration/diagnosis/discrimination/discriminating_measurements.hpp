// Further measurements that discriminate between the explanations that a diagnosis leaves open.
//
// Every explanation predicts a measurement with its own parameters, as determined by the measurements so far: mean f
// and covariance S = I + H P H^T, in standard deviations of the noise, with the sensitivity H to the parameters and
// their covariance P. If explanation a is true, a further measurement raises -2 log of the posterior of b relative to a
// on average by twice the Kullback-Leibler divergence,
//   d^T S_b^-1 d + tr(S_b^-1 S_a) - rows + ln det S_b - ln det S_a,   d = f_a - f_b.
// S_b accounts for the part of d that the free parameters and effects of b could absorb. Measurements are chosen one by
// one to minimise the remaining odds of wrong explanations (Box and Hill 1967; Atkinson and Fedorov 1975).
#pragma once

#include <string>
#include <vector>

#include "calibration/design/next_measurements.hpp"
#include "calibration/diagnosis/judgement/diagnosis_result.hpp"

namespace tubeplan::calibration {

struct DiscriminationOptions {
  int count = 6;  ///< number of measurements to propose; all touches of one unknown point together are one measurement
  /// A decision between explanations requires this probability, both against each rival and against all rivals
  /// together.
  double required_probability = 0.98;
  /// Measurements are repeated until each pair of explanations is decided correctly with at least this probability.
  double assured = 0.9;
  /// Maximum number of times that each chosen measurement is measured; pairs that would need more are treated as
  /// inseparable.
  int most_repeats = 4;
  int most_explanations = 8;  ///< maximum number of explanations that are compared; the most probable are kept
  WorkHooks hooks;
};

/// Returns the difference in -2 log posterior at which the better one of two explanations has the probability
/// `required_probability`.
[[nodiscard]] double separationNeeded(double required_probability);

/// Expected outcome for an ordered pair of explanations, given that the first is true.
struct DiscriminatedPair {
  int truth = -1, other = -1;  ///< indices into `explanations`
  double now =
      kNotKnown;  ///< criterion of the other explanation minus criterion of the true one, before further measurements
  double expected = kNotKnown;     ///< expected value of the criterion difference `now` after the measurements
  double probability = kNotKnown;  ///< probability that the measurements decide for the true explanation
};

struct DiscriminatingMeasurement {
  int candidate = -1;  ///< index into the given candidates
  int a = -1, b = -1;  ///< indices of the two explanations that the measurement separates most
  /// Distance between the two predictions, given the measurements chosen before [standard deviations of the noise].
  double separation = kNotKnown;
};

/// Another kind of measurement, and how well the same number of its measurements is expected to separate the
/// explanations.
struct AlternativeMeasurements {
  std::string what;
  /// Smallest expected criterion difference among the pairs; NaN means that it was not computed.
  double least_expected = kNotKnown;
};

enum class DiscriminationStatus { kNotRun, kNothingToDiscriminate, kNoCandidates, kDone, kStopped };

struct DiscriminatingMeasurements {
  DiscriminationStatus status = DiscriminationStatus::kNotRun;
  std::string reason;
  /// Explanations to discriminate; an explanation without effects means that nothing is missing.
  std::vector<Explanation> explanations;
  std::vector<DiscriminatingMeasurement> measurements;
  std::vector<DiscriminatedPair> pairs;
  double least_expected = kNotKnown;  ///< smallest expected criterion difference among the pairs
  double probability = kNotKnown;     ///< probability of naming the true explanation, averaged over the explanations
  /// Number of times to repeat the chosen measurements until every separable pair is decided; 0 if no pair is
  /// separable.
  int times = 0;
  /// Pairs that even `most_repeats` repeats would probably not separate; each pair is listed once.
  std::vector<DiscriminatedPair> never;
  std::vector<AlternativeMeasurements> alternative_measurements;  ///< measurements for the pairs in `never`, best first
  /// Advice on further quantities to record, so that more effects can be tried.
  std::vector<std::string> columns;
};

/// Returns up to `most` explanations that a diagnosis leaves open. If the verdict is ambiguous, these are its
/// alternatives. If it is inconclusive, these are the model with nothing missing, then the closest models. Otherwise
/// none is open. With fewer than two explanations there is nothing to discriminate.
[[nodiscard]] std::vector<Explanation> openExplanations(const Diagnosis& diagnosis, int most);

/// Returns a name such as "backlash@tool.z with hysteresis@theta4"; "nothing missing" without effects.
[[nodiscard]] std::string nameOf(const Explanation& explanation);

/// Proposes measurements that discriminate between the open explanations of `diagnosis`, which was made from
/// `measurements`. Candidates are measured in the last set-up; each is chosen at most once.
[[nodiscard]] DiscriminatingMeasurements proposeDiscriminatingMeasurements(
    const Diagnosis& diagnosis, const std::vector<Measurement>& measurements,
    const std::vector<MeasurementCandidate>& candidates, const DiscriminationOptions& options = {});

}  // namespace tubeplan::calibration
