// Further readings that discriminate between the explanations that a diagnosis leaves open.
//
// Every explanation predicts a reading with its own parameters, as determined by the readings so far: mean f and
// covariance S = I + H P H^T, in standard deviations of the noise, with the sensitivity H to the parameters and their
// covariance P. If explanation a is true, a further reading raises -2 log of the posterior of b relative to a on
// average by twice the Kullback-Leibler divergence,
//   d^T S_b^-1 d + tr(S_b^-1 S_a) - rows + ln det S_b - ln det S_a,   d = f_a - f_b,
// without the component that the free parameters and effects of b could absorb. Readings are chosen one by one to
// minimise the remaining odds of wrong explanations (Box and Hill 1967; Atkinson and Fedorov 1975).
#pragma once

#include <string>
#include <vector>

#include "calibration/design/next_readings.hpp"
#include "calibration/diagnosis/judgement/diagnosis_result.hpp"

namespace tubeplan::calibration {

struct DiscriminationOptions {
  int count = 6;  ///< number of readings to propose, or of sets of touches of one unknown point
  /// Smallest probability at which an explanation counts as decided, against one rival and against all rivals.
  double sure = 0.98;
  /// Smallest probability of a correct decision at which the readings need no further repeats.
  double assured = 0.9;
  /// Maximum number of times that the chosen readings are measured; pairs that are still undecided count as
  /// inseparable.
  int most_repeats = 4;
  int most_explanations = 8;  ///< maximum number of explanations that are compared; the best are kept
  WorkHooks hooks;
};

/// Returns the difference between -2 log of the posteriors of two explanations at which the better one has the
/// probability `sure`.
[[nodiscard]] double separationNeeded(double sure);

/// Expected outcome for an ordered pair of explanations, given that the first is true.
struct DiscriminatedPair {
  int truth = -1, other = -1;  ///< indices into `explanations`
  double now = kNotKnown;  ///< criterion of the other explanation minus that of the true one, before further readings
  double expected = kNotKnown;     ///< expected value of the criterion difference `now` after the readings
  double probability = kNotKnown;  ///< probability that the readings decide for the true explanation
};

struct DiscriminatingMeasurement {
  int candidate = -1;  ///< index among the given candidates
  int a = -1, b = -1;  ///< indices of the two explanations that the reading separates most
  /// Distance between the two predictions, given the readings chosen before [standard deviations of the noise].
  double separation = kNotKnown;
};

/// Another kind of measurement, and how well the same number of its readings is expected to separate the explanations.
struct AlternativeMeasurements {
  std::string what;
  double least_expected = kNotKnown;  ///< smallest expected criterion difference among the pairs; NaN: not computed
};

enum class DiscriminationStatus { kNotRun, kNothingToDiscriminate, kNoCandidates, kDone, kStopped };

struct DiscriminatingMeasurements {
  DiscriminationStatus status = DiscriminationStatus::kNotRun;
  std::string reason;
  /// Explanations to discriminate; an explanation without effects means that nothing is missing.
  std::vector<Explanation> explanations;
  std::vector<DiscriminatingMeasurement> readings;
  std::vector<DiscriminatedPair> pairs;
  double least_expected = kNotKnown;  ///< smallest expected criterion difference among the pairs
  double probability = kNotKnown;     ///< probability of naming the true explanation, averaged over the explanations
  /// Number of times to measure the chosen readings until every separable pair is decided; 0: no pair is separable.
  int times = 0;
  /// Pairs, in one order each, that `most_repeats` repeats probably do not separate.
  std::vector<DiscriminatedPair> never;
  std::vector<AlternativeMeasurements> alternative_measurements;  ///< measurements for the pairs in `never`, best first
  std::vector<std::string> columns;  ///< advice on what else to record, for effects that could not be tried
};

/// Returns up to `most` explanations that a diagnosis leaves open. If the verdict is ambiguous: its alternatives; if
/// inconclusive: nothing missing, then the closest models; otherwise none. With fewer than two explanations there is
/// nothing to discriminate.
[[nodiscard]] std::vector<Explanation> openExplanations(const Diagnosis& diagnosis, int most);

/// Returns a name such as "backlash@tool.z with hysteresis@theta4"; "nothing missing" without effects.
[[nodiscard]] std::string nameOf(const Explanation& explanation);

/// Proposes readings that discriminate between the open explanations. `readings` are the diagnosed readings. Candidates
/// are measured in the last set-up; each is chosen at most once.
[[nodiscard]] DiscriminatingMeasurements proposeDiscriminatingMeasurements(
    const Diagnosis& diagnosis, const std::vector<Measurement>& readings,
    const std::vector<ReadingCandidate>& candidates, const DiscriminationOptions& options = {});

}  // namespace tubeplan::calibration
