// Noise common to several readings: errors of encoders that were read once for all of them.
#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

/// The encoders' errors at one posture, which affect every reading there: several readings at the same joint values,
/// and the reference posture of a campaign's displacements.
///
/// With the readings' own noise whitened, the covariance with common errors is I + U U^T, U the whitened
/// slopes times the encoders' standard deviations. Its inverse root is I - Q diag(shrink) Q^T, with Q the
/// eigenvectors of U U^T and shrink = 1 - (1 + eigenvalue)^(-1/2).
struct SharedNoise {
  std::vector<int> readings;
  /// Rows x joints of each reading [m, rad], per standard deviation of an encoder.
  std::vector<Eigen::MatrixXd> slopes;
  std::vector<int> mixed;  ///< these readings, and those that share other noise with them
  Eigen::MatrixXd Q;       ///< rows of `mixed`, one after another
  Eigen::VectorXd shrink;
};

struct ReadingWeights;

/// Returns the standard deviation of each joint's reading [rad, m].
[[nodiscard]] Eigen::VectorXd encoderSigmas(const deflection::Arm& arm);

/// Returns the shared noise, from the matrix `by_joints` of each reading (ReadingPredictor), smallest groups first; Q
/// and shrink are still empty. In `by_joints` only the noise of a reading alone is left, the rest is set to zero.
/// Touches of an unknown point share noise only with touches of that point.
[[nodiscard]] std::vector<SharedNoise> separateSharedNoise(const deflection::Arm& arm,
                                                           const std::vector<Measurement>& readings,
                                                           std::vector<Eigen::MatrixXd>& by_joints);

/// Returns the first row of each of these readings when they are stacked alone, and the total number of rows.
[[nodiscard]] std::pair<std::map<int, Eigen::Index>, Eigen::Index> rowsAlone(const ReadingWeights& weights,
                                                                             const std::vector<int>& readings);

/// Computes Q and shrink of the weights' shared noise from their whiteners.
void placeSharedNoise(ReadingWeights& weights);

/// Transforms whitened columns (rows of `weights`) to those of readings without common noise.
void decorrelate(const ReadingWeights& weights, Eigen::Ref<Eigen::MatrixXd> columns);

/// Transforms the rows of these readings alone, one after another; noise shared with other readings remains.
void decorrelateWithin(const ReadingWeights& weights, const std::vector<int>& readings,
                       Eigen::Ref<Eigen::MatrixXd> rows);

}  // namespace tubeplan::calibration
