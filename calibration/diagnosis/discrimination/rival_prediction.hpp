// What rival explanations predict of readings to come, and how far such readings would tell them apart.
#pragma once

#include <vector>

#include "calibration/design/next_readings.hpp"
#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"
#include "calibration/diagnosis/explanations/explanation_model.hpp"

namespace tubeplan::calibration {

/// An explanation with what the readings so far determine of its numbers.
struct RivalModel {
  ExplanationModel model;
  double criterion = 0;
  Eigen::MatrixXd covariance;  ///< of the unknowns
};

[[nodiscard]] std::vector<RivalModel> rivalModelsOf(const FittedBasis& basis,
                                                    const std::vector<Explanation>& explanations);

/// That each is true, if one of them is.
[[nodiscard]] std::vector<double> probabilitiesOf(const std::vector<RivalModel>& rivals);

/// Whitened rows that each rival predicts at one candidate, and their sensitivities to its unknowns.
struct RivalPrediction {
  std::vector<Eigen::VectorXd> value;
  std::vector<Eigen::MatrixXd> sensitivity;
};

/// At each candidate; no rivals' entries where a shape does not converge. Unwinds where it was stopped.
[[nodiscard]] std::vector<RivalPrediction> predictByRivals(const std::vector<RivalModel>& rivals,
                                                           const std::vector<ReadingCandidate>& candidates,
                                                           const StopQuestion& stop = {});

/// A greedy choice of candidates, each at most once; its pairs are of rivals.
[[nodiscard]] std::vector<DiscriminatingMeasurement> chooseDiscriminating(
    const std::vector<RivalModel>& rivals, const std::vector<RivalPrediction>& predictions, int count,
    const StopQuestion& stop = {});

/// The rise of -2 log of b's posterior over a's by chosen candidates, made `times` times, when a is true.
struct ExpectedRise {
  double mean = 0, sigma = 0;
};
[[nodiscard]] ExpectedRise expectedRise(const std::vector<RivalModel>& rivals,
                                        const std::vector<RivalPrediction>& predictions,
                                        const std::vector<DiscriminatingMeasurement>& steps, int a, int b, int times);

/// The least, over all ordered pairs, of the other's criterion less that of the truth, in the mean, after these steps.
[[nodiscard]] double leastExpected(const std::vector<RivalModel>& rivals,
                                   const std::vector<RivalPrediction>& predictions,
                                   const std::vector<DiscriminatingMeasurement>& steps);

}  // namespace tubeplan::calibration
