// Noise shared by several readings: errors of encoders that were read once for all of them.
#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

/// Encoder errors at one posture, which are common to all readings taken there and to all displacements measured from
/// there.
///
/// With the readings' own noise whitened, the covariance with shared errors is I + U U^T, where U is the whitened
/// derivatives times the encoders' standard deviations. The inverse square root of this covariance is I - Q
/// diag(shrink) Q^T, where Q holds the eigenvectors of U U^T and shrink = 1 - (1 + eigenvalue)^(-1/2).
struct SharedNoise {
  std::vector<int> readings;
  /// Derivatives of each reading (rows x joints) with respect to the joints, times the encoders' standard deviations
  /// [m].
  std::vector<Eigen::MatrixXd> slopes;
  std::vector<int> mixed;  ///< indices of `readings`, and of all readings that share other noise with them
  Eigen::MatrixXd Q;       ///< eigenvectors of U U^T, with the stacked rows of the readings `mixed`
  Eigen::VectorXd shrink;
};

struct ReadingWeights;

/// Returns the standard deviation of each joint reading [rad, m].
[[nodiscard]] Eigen::VectorXd encoderSigmas(const deflection::Arm& arm);

/// Returns the shared noise, smallest groups first, from the matrix `by_joints` of each reading (Prediction). Q and
/// shrink are still empty. On return, `by_joints` keeps only the noise of single readings; the rest is set to zero.
/// Touches of an unknown point share noise only with touches of the same point.
[[nodiscard]] std::vector<SharedNoise> separateSharedNoise(const deflection::Arm& arm,
                                                           const std::vector<Measurement>& readings,
                                                           std::vector<Eigen::MatrixXd>& by_joints);

/// Returns the first row of each of these readings if only they are stacked, and the total number of rows.
[[nodiscard]] std::pair<std::map<int, Eigen::Index>, Eigen::Index> rowsAlone(const ReadingWeights& weights,
                                                                             const std::vector<int>& readings);

/// Computes Q and shrink of `weights.shared` from the whiteners.
void placeSharedNoise(ReadingWeights& weights);

/// Removes the correlation due to shared noise from whitened columns, which have the rows of `weights`.
void decorrelate(const ReadingWeights& weights, Eigen::Ref<Eigen::MatrixXd> columns);

/// Removes the correlation due to shared noise from the stacked rows of these readings alone; noise shared with other
/// readings remains.
void decorrelateWithin(const ReadingWeights& weights, const std::vector<int>& readings,
                       Eigen::Ref<Eigen::MatrixXd> rows);

}  // namespace tubeplan::calibration
