// The residual of a whole campaign in units of its noise: for every kind of reading and any number of set-ups, with
// unmeasured touched points eliminated exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/shared_noise.hpp"
#include "calibration/hooks.hpp"
#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::calibration {

/// Rows of each reading, their weights, and the groups of readings that touched one unknown point.
///
/// Elimination: whitened readings of one unknown point P are W_i p_i with Q an orthonormal basis of the stacked W_i;
/// the best P leaves (I - Q Q^T) W p. So the point costs 3 degrees of freedom and no variable. Of a touched surface the
/// stacked rows are W_i C_i, with C_i the slopes of the reading by the surface's numbers;
/// undetermined directions cost nothing.
struct ReadingWeights {
  struct UnknownPoint {
    std::string name;
    std::vector<int> readings;
    Eigen::MatrixXd Q;  ///< basis with as many rows as all of its readings have, at most one column for each number
    Eigen::MatrixXd estimate;  ///< matrix from the stacked errors to the numbers of the place
  };
  std::vector<int> first_row;              ///< first row of each reading
  std::vector<Eigen::MatrixXd> whitener;   ///< L^-1 of the own covariance L L^T, times the root of its weight
  std::vector<Eigen::MatrixXd> noise;      ///< covariance of each reading by its own and the encoders' noise [m^2]
  std::vector<Eigen::MatrixXd> own_noise;  ///< covariance without the part that it shares with other readings [m^2]
  std::vector<Eigen::MatrixXd> by_place_numbers;  ///< C_i; empty for readings without an unknown place
  std::vector<SharedNoise> shared;
  double model_error = 0;  ///< standard deviation of each coordinate beyond the noise, added to every covariance [m]
  std::vector<UnknownPoint> points;
  int rows = 0;
  int degrees_of_freedom = 0;  ///< rows less those of the points

  /// Returns the covariance of a reading alone: its noise and the model's own error [m^2].
  [[nodiscard]] Eigen::MatrixXd covariance(std::size_t reading) const;
};

/// Returns the weights at a state of the arm: the covariance of each reading with its encoders' noise. `factors`, if
/// given, are the weights of a robust fit, one for each reading. Nothing if the model cannot be evaluated; throws
/// WorkStopped if it is stopped.
[[nodiscard]] std::optional<ReadingWeights> weighReadings(const PlacedArm& placed,
                                                          const std::vector<Measurement>& readings,
                                                          const Eigen::VectorXd& factors = {}, double model_error = 0,
                                                          const StopQuestion& stop = {});

/// Returns the weights with another model error or other factors.
[[nodiscard]] ReadingWeights reweighted(const ReadingWeights& weights, const std::vector<Measurement>& readings,
                                        double model_error, const Eigen::VectorXd& factors = {});

struct WhitenedResidual {
  bool ok = false;
  Eigen::VectorXd r;         ///< whitened residual, predicted minus measured; rows of `weights`
  Eigen::MatrixXd jacobian;  ///< Jacobian by the unknowns' variables, if asked for
  /// Residual in metres, predicted minus measured, not whitened; for an unknown point, from its estimate.
  Eigen::VectorXd error;
};

/// Returns the residual at variables x of the unknowns, from the state `start`; throws WorkStopped.
[[nodiscard]] WhitenedResidual whitenedResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                                const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                                const Eigen::VectorXd& x, bool with_jacobian,
                                                const StopQuestion& stop = {});

/// Removes from columns (rows of `weights`) that each reading's whitener has weighted the parts that readings have in
/// common: noise of encoders that were read once, and the components that the unknown points absorb.
void takeSharedOff(const ReadingWeights& weights, Eigen::Ref<Eigen::MatrixXd> columns);

/// Removes them from the rows of these readings alone, one after another, as far as they share with no others.
void takeOffWithin(const ReadingWeights& weights, const std::vector<int>& readings, Eigen::MatrixXd& rows);

/// Returns the length of each reading's error [m].
[[nodiscard]] Eigen::VectorXd errorLengths(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                           const Eigen::VectorXd& error);

/// Returns the root mean square over the readings of the square root of their rows: the length of an error of one in
/// each row.
[[nodiscard]] double lengthOfRows(const std::vector<Measurement>& readings);

/// Returns the rms error from noise alone: root mean square over the readings of the error's length [m], after
/// subtraction of the touched points' estimates.
[[nodiscard]] double noiseFloor(const std::vector<Measurement>& readings, const ReadingWeights& weights);

}  // namespace tubeplan::calibration
