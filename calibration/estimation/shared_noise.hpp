// Noise that several measurements share, because the encoders were read only once for all of them.
#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

/// Encoder errors at one posture. All measurements taken at this posture share them, and so do displacements measured
/// from it.
///
/// With the measurements' own noise whitened, the covariance with shared errors is I + U U^T, where U is the whitened
/// derivatives times the encoders' standard deviations. The inverse square root of this covariance is I - Q
/// diag(shrink) Q^T, where Q holds the eigenvectors of U U^T and shrink = 1 - (1 + eigenvalue)^(-1/2).
struct SharedNoise {
  std::vector<int> measurements;
  /// Derivatives of each measurement (rows x joints) with respect to the joint readings, times the encoders' standard
  /// deviations [m].
  std::vector<Eigen::MatrixXd> slopes;
  std::vector<int> mixed;  ///< indices of these measurements and of all others that share any noise with them
  Eigen::MatrixXd Q;       ///< eigenvectors of U U^T; its rows are the stacked rows of the measurements `mixed`
  Eigen::VectorXd shrink;
};

struct MeasurementWeights;

/// Returns the standard deviation of each joint reading [rad, m].
[[nodiscard]] Eigen::VectorXd encoderSigmas(const deflection::Arm& arm);

/// Returns one SharedNoise for each posture whose encoder errors several measurements share, smallest groups first; its
/// Q and shrink are still empty. `by_joints` holds each measurement's derivatives with respect to the joints
/// (Prediction); its columns that belong to shared noise are set to zero. Touches of an unknown point share noise only
/// with touches of the same point.
[[nodiscard]] std::vector<SharedNoise> separateSharedNoise(const deflection::Arm& arm,
                                                           const std::vector<Measurement>& measurements,
                                                           std::vector<Eigen::MatrixXd>& by_joints);

/// Returns the first row of each of these measurements in a matrix that stacks only their rows, and the number of its
/// rows.
[[nodiscard]] std::pair<std::map<int, Eigen::Index>, Eigen::Index> stackedRows(const MeasurementWeights& weights,
                                                                               const std::vector<int>& measurements);

/// Computes `mixed`, Q and shrink of each entry of `weights.shared` from the measurements' whiteners.
void placeSharedNoise(MeasurementWeights& weights);

/// Removes the correlation due to shared noise from whitened columns, whose rows are those of all measurements of
/// `weights`.
void decorrelate(const MeasurementWeights& weights, Eigen::Ref<Eigen::MatrixXd> columns);

/// Like decorrelate(), for a matrix that stacks only the rows of these measurements. Noise that they share with other
/// measurements is not removed.
void decorrelateWithin(const MeasurementWeights& weights, const std::vector<int>& measurements,
                       Eigen::Ref<Eigen::MatrixXd> rows);

}  // namespace tubeplan::calibration
