// Which further readings would split the explanations that a diagnosis cannot tell apart.
//
// Every explanation predicts a reading from what the readings so far say of its own numbers: mean f and covariance
// S = I + H P H^T, in noise sigmas. If a is true, a further reading raises -2 log of b's posterior over that of a in
// the mean by twice their Kullback-Leibler divergence,
//   d^T S_b^-1 d + tr(S_b^-1 S_a) - rows + ln det S_b - ln det S_a,   d = f_a - f_b:
// what b's free numbers and sizes could absorb is taken off. Readings are taken one by one so that the odds which this
// leaves to wrong explanations become as small as possible (Box and Hill 1967; Atkinson and Fedorov 1975).
#pragma once

#include <string>
#include <vector>

#include "calibration/design/next_readings.hpp"
#include "calibration/diagnosis/judgement/diagnosis_result.hpp"

namespace tubeplan::calibration {

struct DiscriminationOptions {
  int count = 6;              ///< readings, or sets of touches of one unknown point
  double sure = 0.98;         ///< probability of one of two explanations that names it, beside all others too
  double assured = 0.9;       ///< chance that they do so which counts as a promise
  int most_repeats = 4;       ///< of the whole choice, before postures are said not to split at all
  int most_explanations = 8;  ///< that are split, best first
  WorkHooks hooks;
};

/// Of -2 log of two posteriors: the difference from which one of the two has the probability `sure`.
[[nodiscard]] double separationNeeded(double sure);

/// One ordered pair: what is to be expected when the first is true.
struct DiscriminatedPair {
  int truth = -1, other = -1;      ///< indices of the explanations
  double now = kNotKnown;          ///< criterion of the other less that of the first
  double expected = kNotKnown;     ///< the same after the readings, in the mean
  double probability = kNotKnown;  ///< that the first is then named rather than both
};

struct DiscriminatingMeasurement {
  int candidate = -1;             ///< index of what was given
  int a = -1, b = -1;             ///< the explanations that it splits most
  double separation = kNotKnown;  ///< of their predictions, in noise sigmas, on top of
                                  ///< the readings before it
};

/// What else could be measured, and what that many of it would do.
struct AlternativeMeasurements {
  std::string what;
  double least_expected = kNotKnown;  ///< as of DiscriminatingMeasurements; NaN: not computed
};

enum class DiscriminationStatus { kNotRun, kNothingToDiscriminate, kNoCandidates, kDone, kStopped };

struct DiscriminatingMeasurements {
  DiscriminationStatus status = DiscriminationStatus::kNotRun;
  std::string reason;
  std::vector<Explanation> explanations;  ///< that are to be split; one without effects says that nothing is missing
  std::vector<DiscriminatingMeasurement> readings;
  std::vector<DiscriminatedPair> pairs;
  double least_expected = kNotKnown;     ///< of the pairs
  double probability = kNotKnown;        ///< that one is named, whichever is true
  int times = 0;                         ///< that the choice must be made until what can be split is; 0: nothing can
  std::vector<DiscriminatedPair> never;  ///< pairs, each once, that the most repeats are unlikely to split
  std::vector<AlternativeMeasurements> alternative_measurements;  ///< for those pairs, best first
  std::vector<std::string> columns;                               ///< what to write down beside: effects not tried
};

/// The explanations that a diagnosis leaves open: its alternatives; where it was inconclusive, that nothing is missing
/// and the closest; where none is enough, those that do as well as the best. Fewer than two: nothing to split.
[[nodiscard]] std::vector<Explanation> openExplanations(const Diagnosis& diagnosis, int most);

/// "backlash@tool.z with hysteresis@theta4"; "nothing missing" without effects.
[[nodiscard]] std::string nameOf(const Explanation& explanation);

/// `readings` are those that were diagnosed. Candidates are made in the last set-up; each is taken at most once.
[[nodiscard]] DiscriminatingMeasurements proposeDiscriminatingMeasurements(
    const Diagnosis& diagnosis, const std::vector<Measurement>& readings,
    const std::vector<ReadingCandidate>& candidates, const DiscriminationOptions& options = {});

}  // namespace tubeplan::calibration
