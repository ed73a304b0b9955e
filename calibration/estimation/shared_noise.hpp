// Noise that several readings have in common: encoders that were read once for all of them.
#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

/// The encoders' errors at one posture, which reach every reading there: several shots at the same joint readings, and
/// the posture that the ways of a whole campaign are taken from.
///
/// With the readings' own noise whitened, what the common errors add to their covariance is I + U U^T, U the whitened
/// slopes times the encoders' standard deviations. Its inverse root is I - Q diag(shrink) Q^T, with Q the
/// eigenvectors of U U^T and shrink = 1 - (1 + eigenvalue)^(-1/2).
struct SharedNoise {
  std::vector<int> readings;
  std::vector<Eigen::MatrixXd> slopes;  ///< of each, rows x joints [m, rad]: by one standard deviation of an encoder
  std::vector<int> mixed;               ///< these readings, and those that share other noise with them
  Eigen::MatrixXd Q;                    ///< rows of `mixed`, one after another
  Eigen::VectorXd shrink;
};

struct ReadingWeights;

/// What is shared, by `by_joints` of each reading (ReadingPredictor), the smallest first; Q and shrink are empty yet.
/// What a reading has for itself is left in `by_joints`, the rest of it zero. Touches of an unknown point share noise
/// with touches of that point only.
[[nodiscard]] std::vector<SharedNoise> separateSharedNoise(const deflection::Arm& arm,
                                                           const std::vector<Measurement>& readings,
                                                           std::vector<Eigen::MatrixXd>& by_joints);

/// Where the rows of these readings begin when they stand alone, one after another, and how many there are.
[[nodiscard]] std::pair<std::map<int, Eigen::Index>, Eigen::Index> rowsAlone(const ReadingWeights& weights,
                                                                             const std::vector<int>& readings);

/// Q and shrink of what the weights share, by their whiteners.
void placeSharedNoise(ReadingWeights& weights);

/// Makes whitened columns (rows of `weights`) those of readings without noise in common.
void decorrelate(const ReadingWeights& weights, Eigen::Ref<Eigen::MatrixXd> columns);

/// The same of these readings' rows alone, one after another; noise that is shared with other readings stays.
void decorrelateWithin(const ReadingWeights& weights, const std::vector<int>& readings,
                       Eigen::Ref<Eigen::MatrixXd> rows);

}  // namespace tubeplan::calibration
