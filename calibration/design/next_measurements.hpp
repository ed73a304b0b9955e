// Proposals for the next measurements, given those made so far: the postures and loads, or the touches, that most
// reduce the uncertainty of the free parameters or of the tip at the work postures.
#pragma once

#include <string>
#include <vector>

#include "calibration/design/optimal_design.hpp"
#include "calibration/estimation/estimate.hpp"
#include "calibration/measurements/proposed_measurement.hpp"

namespace tubeplan::calibration {

/// A candidate for the next measurement: a single measurement, or several touches of the same unknown point under
/// different loads, because a single touch of such a point gives no information. Each measurement states its set-up and
/// its expected sigma.
struct MeasurementCandidate {
  std::vector<ProposedMeasurement> measurements;
};

/// Work postures of the arm, at which the tip position must be accurate.
struct Work {
  std::vector<Eigen::VectorXd> postures;
  double load = 0;  ///< load hung from the tip [N]
};

struct NextMeasurementsOptions {
  DesignOptions design;
  int random_draws = 20;  ///< number of random selections of `design.count` measurements, for comparison
  std::uint64_t seed = 1;
};

/// Standard deviations of one free parameter, in its own unit: at present, after the proposed measurements, and after
/// the same number of randomly selected measurements (median over the random selections).
struct NumberForecast {
  Unknown unknown;
  double value = 0;
  double now = std::numeric_limits<double>::quiet_NaN();
  double after = std::numeric_limits<double>::quiet_NaN();
  double random = std::numeric_limits<double>::quiet_NaN();
  bool is_identifiable_now = false, is_identifiable_after = false,
       is_identifiable_random = false;  ///< true if sigma is less than half of the typical size
};

enum class NextMeasurementsStatus { kNotRun, kDone, kTooFewCandidates };

struct NextMeasurements {
  NextMeasurementsStatus status = NextMeasurementsStatus::kNotRun;
  std::string reason;
  /// Indices of the candidates at which the arm's deflected shape converges; candidate indices in `design` are
  /// positions in this list.
  std::vector<int> candidates;
  Design design;
  std::vector<NumberForecast> numbers;
  /// Standard deviation of the predicted tip position, without encoder noise [m].
  TipSigma tip_now, tip_after, tip_random;
  double bits = std::numeric_limits<double>::quiet_NaN();  ///< total information gain [bit]
  double bits_random = std::numeric_limits<double>::quiet_NaN();
};

/// Design problem restricted to the candidates at which the arm's deflected shape converges.
struct PosedDesign {
  DesignProblem problem;
  std::vector<int> candidates;  ///< for each candidate of the problem, its index among all candidates
};
[[nodiscard]] PosedDesign poseDesign(const Estimate& estimate, const std::vector<MeasurementCandidate>& candidates,
                                     const Work& work);

/// Predicts the standard deviations after the measurements chosen in `design`, and after the same number of randomly
/// selected measurements.
[[nodiscard]] NextMeasurements forecastMeasurements(const Estimate& estimate, const PosedDesign& posed, Design design,
                                                    const NextMeasurementsOptions& options = {});

/// Selects the best measurements by the criterion `options.design.optimality`, and predicts their effect as
/// forecastMeasurements() does.
[[nodiscard]] NextMeasurements proposeMeasurements(const Estimate& estimate,
                                                   const std::vector<MeasurementCandidate>& candidates,
                                                   const Work& work, const NextMeasurementsOptions& options = {});

}  // namespace tubeplan::calibration
