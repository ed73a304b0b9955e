// Predictions of further readings by rival explanations, and the expected discrimination by such readings.
#pragma once

#include <vector>

#include "calibration/design/next_readings.hpp"
#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"
#include "calibration/diagnosis/explanations/explanation_model.hpp"

namespace tubeplan::calibration {

/// Explanation with the uncertainty of its numbers after the readings so far.
struct RivalModel {
  ExplanationModel model;
  double criterion = 0;
  Eigen::MatrixXd covariance;  ///< covariance of the unknowns
};

[[nodiscard]] std::vector<RivalModel> rivalModelsOf(const FittedBasis& basis,
                                                    const std::vector<Explanation>& explanations);

/// Returns the probability of each rival, given that one of them is true.
[[nodiscard]] std::vector<double> probabilitiesOf(const std::vector<RivalModel>& rivals);

/// Whitened rows predicted by each rival at one candidate, and their sensitivities to its unknowns.
struct RivalPrediction {
  std::vector<Eigen::VectorXd> value;
  std::vector<Eigen::MatrixXd> sensitivity;
};

/// Returns the predictions at each candidate; without entries if a shape does not converge. Throws WorkStopped on a
/// request to stop.
[[nodiscard]] std::vector<RivalPrediction> predictByRivals(const std::vector<RivalModel>& rivals,
                                                           const std::vector<ReadingCandidate>& candidates,
                                                           const StopQuestion& stop = {});

/// Chooses up to `count` candidates greedily, each at most once. The pairs `a`, `b` are indices of rivals.
[[nodiscard]] std::vector<DiscriminatingMeasurement> chooseDiscriminating(
    const std::vector<RivalModel>& rivals, const std::vector<RivalPrediction>& predictions, int count,
    const StopQuestion& stop = {});

/// Rise of -2 log of b's posterior over a's by the chosen candidates, each measured `times` times, if a is true.
struct ExpectedRise {
  double mean = 0, sigma = 0;
};
[[nodiscard]] ExpectedRise expectedRise(const std::vector<RivalModel>& rivals,
                                        const std::vector<RivalPrediction>& predictions,
                                        const std::vector<DiscriminatingMeasurement>& steps, int a, int b, int times);

/// Returns the least mean difference after these steps of the other's criterion minus that of the true rival, over all
/// ordered pairs.
[[nodiscard]] double leastExpected(const std::vector<RivalModel>& rivals,
                                   const std::vector<RivalPrediction>& predictions,
                                   const std::vector<DiscriminatingMeasurement>& steps);

}  // namespace tubeplan::calibration
