// Proposals of the next measurements: postures and loads, or touches, that improve the free numbers and the tip at work
// most, given present knowledge.
#pragma once

#include <string>
#include <vector>

#include "calibration/design/optimal_design.hpp"
#include "calibration/estimation/estimate.hpp"
#include "calibration/measurements/proposed_measurement.hpp"

namespace tubeplan::calibration {

/// A possible proposal: one reading, or the touches of one unknown place under several loads, which determine nothing
/// singly. Sigma is that expected of the reading; the set-up is filled in.
struct ReadingCandidate {
  std::vector<ProposedMeasurement> readings;
};

/// Postures where the tip must be known.
struct Work {
  std::vector<Eigen::VectorXd> postures;
  double load = 0;  ///< [N]
};

struct NextReadingsOptions {
  DesignOptions design;
  int random_draws = 20;  ///< random choices of as many readings, for comparison
  std::uint64_t seed = 1;
};

/// Sigma of one free number, in its own unit: before, after the proposed readings, and after as many random ones
/// (median of the draws).
struct NumberForecast {
  Unknown unknown;
  double value = 0;
  double now = std::numeric_limits<double>::quiet_NaN();
  double after = std::numeric_limits<double>::quiet_NaN();
  double random = std::numeric_limits<double>::quiet_NaN();
  bool is_identifiable_now = false, is_identifiable_after = false,
       is_identifiable_random = false;  ///< true: better known than by its typical size
};

enum class NextReadingsStatus { kNotRun, kDone, kTooFewCandidates };

struct NextReadings {
  NextReadingsStatus status = NextReadingsStatus::kNotRun;
  std::string reason;
  std::vector<int> candidates;  ///< indices of those whose shape converges, to which the design's indices refer
  Design design;
  std::vector<NumberForecast> numbers;
  TipSigma tip_now, tip_after, tip_random;                 ///< sigma of the model's tip, without the encoders' noise
  double bits = std::numeric_limits<double>::quiet_NaN();  ///< information gained in all
  double bits_random = std::numeric_limits<double>::quiet_NaN();
};

/// The design problem of the candidates; those whose shape does not converge are left out.
struct PosedDesign {
  DesignProblem problem;
  std::vector<int> candidates;  ///< index of each of the problem's candidates
};
[[nodiscard]] PosedDesign poseDesign(const Estimate& estimate, const std::vector<ReadingCandidate>& candidates,
                                     const Work& work);

/// Returns the effect of a choice of the posed design's readings, beside as many random ones.
[[nodiscard]] NextReadings forecastReadings(const Estimate& estimate, const PosedDesign& posed, Design design,
                                            const NextReadingsOptions& options = {});

/// Returns the best readings by the options' optimality, and their effect.
[[nodiscard]] NextReadings proposeReadings(const Estimate& estimate, const std::vector<ReadingCandidate>& candidates,
                                           const Work& work, const NextReadingsOptions& options = {});

}  // namespace tubeplan::calibration
