// Noise that several readings share, because the encoders were read only once for all of them.
#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

/// Encoder errors at one posture. All readings taken at this posture share them, and so do displacements measured from
/// it.
///
/// With the readings' own noise whitened, the covariance with shared errors is I + U U^T, where U is the whitened
/// derivatives times the encoders' standard deviations. The inverse square root of this covariance is I - Q
/// diag(shrink) Q^T, where Q holds the eigenvectors of U U^T and shrink = 1 - (1 + eigenvalue)^(-1/2).
struct SharedNoise {
  std::vector<int> readings;
  /// Derivatives of each reading (rows x joints) with respect to the joint readings, times the encoders' standard
  /// deviations [m].
  std::vector<Eigen::MatrixXd> slopes;
  std::vector<int> mixed;  ///< indices of these readings and of all others that share any noise with them
  Eigen::MatrixXd Q;       ///< eigenvectors of U U^T; its rows are the stacked rows of the readings `mixed`
  Eigen::VectorXd shrink;
};

struct ReadingWeights;

/// Returns the standard deviation of each joint reading [rad, m].
[[nodiscard]] Eigen::VectorXd encoderSigmas(const deflection::Arm& arm);

/// Returns one SharedNoise for each posture whose encoder errors several readings share, smallest groups first; its Q
/// and shrink are still empty. `by_joints` holds each reading's derivatives with respect to the joints (Prediction);
/// columns that belong to shared noise are set to zero in it. Touches of an unknown point share noise only with touches
/// of the same point.
[[nodiscard]] std::vector<SharedNoise> separateSharedNoise(const deflection::Arm& arm,
                                                           const std::vector<Measurement>& readings,
                                                           std::vector<Eigen::MatrixXd>& by_joints);

/// Returns the first row of each of these readings in a matrix that stacks only their rows, and the number of its rows.
[[nodiscard]] std::pair<std::map<int, Eigen::Index>, Eigen::Index> rowsAlone(const ReadingWeights& weights,
                                                                             const std::vector<int>& readings);

/// Computes `mixed`, Q and shrink of each entry of `weights.shared` from the readings' whiteners.
void placeSharedNoise(ReadingWeights& weights);

/// Removes the correlation due to shared noise from whitened columns, whose rows are those of all readings of
/// `weights`.
void decorrelate(const ReadingWeights& weights, Eigen::Ref<Eigen::MatrixXd> columns);

/// Acts like decorrelate(), but on a matrix that stacks only the rows of these readings. Noise that they share with
/// other readings is not removed.
void decorrelateWithin(const ReadingWeights& weights, const std::vector<int>& readings,
                       Eigen::Ref<Eigen::MatrixXd> rows);

}  // namespace tubeplan::calibration
