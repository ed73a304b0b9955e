// Further readings that discriminate between the explanations that a diagnosis leaves open.
//
// Every explanation predicts a reading from its own numbers as determined by the readings so far: mean f and covariance
// S = I + H P H^T, in noise sigmas. If a is true, a further reading raises -2 log of b's posterior over that of a on
// average by twice their Kullback-Leibler divergence,
//   d^T S_b^-1 d + tr(S_b^-1 S_a) - rows + ln det S_b - ln det S_a,   d = f_a - f_b,
// without the part that b's free numbers and sizes could absorb. Readings are chosen one by one to minimise the
// remaining odds of wrong explanations (Box and Hill 1967; Atkinson and Fedorov 1975).
#pragma once

#include <string>
#include <vector>

#include "calibration/design/next_readings.hpp"
#include "calibration/diagnosis/judgement/diagnosis_result.hpp"

namespace tubeplan::calibration {

struct DiscriminationOptions {
  int count = 6;       ///< number of readings, or of sets of touches of one unknown point
  double sure = 0.98;  ///< probability of one explanation that decides for it, against one other and against all others
  double assured = 0.9;       ///< probability of such a decision that counts as assured
  int most_repeats = 4;       ///< most repeats of the whole choice, after which a pair counts as inseparable
  int most_explanations = 8;  ///< most explanations that are compared, best first
  WorkHooks hooks;
};

/// Returns the difference of -2 log of two posteriors from which one of the two has the probability `sure`.
[[nodiscard]] double separationNeeded(double sure);

/// Expected outcome for an ordered pair of explanations if the first is true.
struct DiscriminatedPair {
  int truth = -1, other = -1;      ///< indices of the explanations
  double now = kNotKnown;          ///< criterion of the other minus that of the first
  double expected = kNotKnown;     ///< mean of the same difference after the readings
  double probability = kNotKnown;  ///< probability that the readings decide for the first
};

struct DiscriminatingMeasurement {
  int candidate = -1;             ///< index among the given candidates
  int a = -1, b = -1;             ///< explanations that it separates most
  double separation = kNotKnown;  ///< distance of their predictions after the readings before it [noise sigmas]
};

/// Another kind of measurement, with the expected effect of as many of them.
struct AlternativeMeasurements {
  std::string what;
  double least_expected = kNotKnown;  ///< least expected difference among the pairs; NaN: not computed
};

enum class DiscriminationStatus { kNotRun, kNothingToDiscriminate, kNoCandidates, kDone, kStopped };

struct DiscriminatingMeasurements {
  DiscriminationStatus status = DiscriminationStatus::kNotRun;
  std::string reason;
  /// Explanations to discriminate; one without effects means that nothing is missing.
  std::vector<Explanation> explanations;
  std::vector<DiscriminatingMeasurement> readings;
  std::vector<DiscriminatedPair> pairs;
  double least_expected = kNotKnown;  ///< least expected difference among the pairs
  double probability = kNotKnown;     ///< probability that one is decided for, whichever is true
  int times = 0;  ///< repeats of the choice until every separable pair is decided; 0: no pair is separable
  std::vector<DiscriminatedPair> never;  ///< pairs, in one order, that even the most repeats probably do not separate
  std::vector<AlternativeMeasurements> alternative_measurements;  ///< measurements for those pairs, best first
  std::vector<std::string> columns;  ///< further columns to record, for effects that could not be tried
};

/// Returns up to `most` explanations that a diagnosis leaves open: its alternatives if ambiguous; nothing missing, then
/// the closest ones, if inconclusive; none for other verdicts. With fewer than two there is nothing to discriminate.
[[nodiscard]] std::vector<Explanation> openExplanations(const Diagnosis& diagnosis, int most);

/// Returns "backlash@tool.z with hysteresis@theta4"; "nothing missing" without effects.
[[nodiscard]] std::string nameOf(const Explanation& explanation);

/// Proposes readings that discriminate between the open explanations. `readings` are the diagnosed ones. Candidates are
/// measured in the last set-up; each is chosen at most once.
[[nodiscard]] DiscriminatingMeasurements proposeDiscriminatingMeasurements(
    const Diagnosis& diagnosis, const std::vector<Measurement>& readings,
    const std::vector<ReadingCandidate>& candidates, const DiscriminationOptions& options = {});

}  // namespace tubeplan::calibration
