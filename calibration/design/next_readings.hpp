// Proposals for the next measurements, given those made so far: the postures and loads, or the touches, that most
// reduce the uncertainty of the free parameters or of the tip at the work postures.
#pragma once

#include <string>
#include <vector>

#include "calibration/design/optimal_design.hpp"
#include "calibration/estimation/estimate.hpp"
#include "calibration/measurements/proposed_measurement.hpp"

namespace tubeplan::calibration {

/// A candidate for proposal: a single reading, or touches of the same unknown point under several loads, each of which
/// gives no information by itself. Each reading states its set-up and its expected sigma.
struct ReadingCandidate {
  std::vector<ProposedMeasurement> readings;
};

/// Work postures, at which the position of the tip must be known.
struct Work {
  std::vector<Eigen::VectorXd> postures;
  double load = 0;  ///< load hung from the tip [N]
};

struct NextReadingsOptions {
  DesignOptions design;
  int random_draws = 20;  ///< number of random choices, each of `design.count` readings, for comparison
  std::uint64_t seed = 1;
};

/// Standard deviations of one free parameter, in the parameter's unit: now, after the proposed readings, and after the
/// same number of random readings (median of the draws).
struct NumberForecast {
  Unknown unknown;
  double value = 0;
  double now = std::numeric_limits<double>::quiet_NaN();
  double after = std::numeric_limits<double>::quiet_NaN();
  double random = std::numeric_limits<double>::quiet_NaN();
  bool is_identifiable_now = false, is_identifiable_after = false,
       is_identifiable_random = false;  ///< true: sigma is below half the typical size
};

enum class NextReadingsStatus { kNotRun, kDone, kTooFewCandidates };

struct NextReadings {
  NextReadingsStatus status = NextReadingsStatus::kNotRun;
  std::string reason;
  /// Indices of the candidates at which the arm's shape converges; the indices in `design` refer to this list.
  std::vector<int> candidates;
  Design design;
  std::vector<NumberForecast> numbers;
  TipSigma tip_now, tip_after, tip_random;                 ///< sigma of the predicted tip, without encoder noise
  double bits = std::numeric_limits<double>::quiet_NaN();  ///< total information gain [bit]
  double bits_random = std::numeric_limits<double>::quiet_NaN();
};

/// Design problem of the candidates at which the arm's shape converges; other candidates are left out.
struct PosedDesign {
  DesignProblem problem;
  std::vector<int> candidates;  ///< index, among all candidates, of each candidate of the problem
};
[[nodiscard]] PosedDesign poseDesign(const Estimate& estimate, const std::vector<ReadingCandidate>& candidates,
                                     const Work& work);

/// Returns the effect of the readings chosen in `design`, in comparison with the same number of random readings.
[[nodiscard]] NextReadings forecastReadings(const Estimate& estimate, const PosedDesign& posed, Design design,
                                            const NextReadingsOptions& options = {});

/// Returns the best readings according to the criterion `options.design.optimality`, and their effect.
[[nodiscard]] NextReadings proposeReadings(const Estimate& estimate, const std::vector<ReadingCandidate>& candidates,
                                           const Work& work, const NextReadingsOptions& options = {});

}  // namespace tubeplan::calibration
