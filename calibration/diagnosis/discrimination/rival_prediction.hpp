// Predictions of further measurements by rival explanations, and how well such measurements are expected to
// discriminate.
#pragma once

#include <vector>

#include "calibration/design/next_measurements.hpp"
#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"
#include "calibration/diagnosis/explanations/explanation_model.hpp"

namespace tubeplan::calibration {

/// Explanation with the covariance of its parameters after the measurements so far.
struct RivalModel {
  ExplanationModel model;
  double criterion = 0;
  Eigen::MatrixXd covariance;  ///< covariance of the unknowns
};

[[nodiscard]] std::vector<RivalModel> rivalModelsOf(const FittedBasis& basis,
                                                    const std::vector<Explanation>& explanations);

/// Returns the probability of each rival, given that one of them is true.
[[nodiscard]] std::vector<double> probabilitiesOf(const std::vector<RivalModel>& rivals);

/// Whitened predictions of one candidate measurement by each rival, and their derivatives with respect to the rival's
/// unknowns.
struct RivalPrediction {
  std::vector<Eigen::VectorXd> value;
  std::vector<Eigen::MatrixXd> sensitivity;
};

/// Returns the rivals' predictions of each candidate; an entry is empty if the arm's shape does not converge. Throws
/// WorkStopped on a request to stop.
[[nodiscard]] std::vector<RivalPrediction> predictByRivals(const std::vector<RivalModel>& rivals,
                                                           const std::vector<MeasurementCandidate>& candidates,
                                                           const StopQuestion& stop = {});

/// Chooses up to `count` candidates one by one, each at most once, to minimise the expected odds of the wrong rivals.
/// In the result, `a` and `b` are indices of rivals.
[[nodiscard]] std::vector<DiscriminatingMeasurement> chooseDiscriminating(
    const std::vector<RivalModel>& rivals, const std::vector<RivalPrediction>& predictions, int count,
    const StopQuestion& stop = {});

/// Mean and standard deviation of the rise of -2 log of the posterior of rival b relative to rival a, if a is true and
/// each chosen candidate is measured `times` times.
struct ExpectedRise {
  double mean = 0, sigma = 0;
};
[[nodiscard]] ExpectedRise expectedRise(const std::vector<RivalModel>& rivals,
                                        const std::vector<RivalPrediction>& predictions,
                                        const std::vector<DiscriminatingMeasurement>& steps, int a, int b, int times);

/// Returns the smallest expected criterion difference over all ordered pairs, after the measurements in `steps`:
/// criterion of the other rival minus criterion of the true one.
[[nodiscard]] double leastExpected(const std::vector<RivalModel>& rivals,
                                   const std::vector<RivalPrediction>& predictions,
                                   const std::vector<DiscriminatingMeasurement>& steps);

}  // namespace tubeplan::calibration
