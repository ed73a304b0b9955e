// The whitened residual of a whole campaign, for every kind of reading and any number of set-ups. Unmeasured touched
// points are eliminated exactly.
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

/// Rows of each reading, their weights, and the groups of readings that touched the same unknown point.
///
/// Elimination: touches of an unknown point P have the residuals W_i (p_i - P), where W_i is the whitener and p_i the
/// predicted tip. Let Q be an orthonormal basis of the stacked W_i. The best P leaves (I - Q Q^T) W p, so the point
/// costs 3 degrees of freedom and no variable. For a touched surface, the stacked rows are W_i C_i, where C_i is the
/// reading's derivative with respect to the surface's parameters. Undetermined directions cost no degree of freedom.
struct ReadingWeights {
  struct UnknownPoint {
    std::string name;
    std::vector<int> readings;
    /// Basis: one row per row of the point's readings, at most one column per parameter of the place.
    Eigen::MatrixXd Q;
    Eigen::MatrixXd estimate;  ///< matrix that maps the stacked errors to the parameters of the place
  };
  std::vector<int> first_row;  ///< index of the first row of each reading
  /// L^-1 of each reading's own covariance L L^T, times the square root of its robust weight factor.
  std::vector<Eigen::MatrixXd> whitener;
  std::vector<Eigen::MatrixXd> noise;  ///< covariance of each reading due to its own noise and encoder noise [m^2]
  /// Covariance of each reading without the part shared with other readings [m^2].
  std::vector<Eigen::MatrixXd> own_noise;
  std::vector<Eigen::MatrixXd> by_place_numbers;  ///< C_i of each reading; empty for readings without an unknown place
  std::vector<SharedNoise> shared;
  double model_error = 0;  ///< standard deviation of the model error of each coordinate, added to every covariance [m]
  std::vector<UnknownPoint> points;
  int rows = 0;
  int degrees_of_freedom = 0;  ///< rows less the degrees of freedom that the unknown places cost

  /// Returns the covariance of a single reading: its noise and the model error [m^2].
  [[nodiscard]] Eigen::MatrixXd covariance(std::size_t reading) const;
};

/// Returns the weights at a state of the arm, from the covariance of each reading including encoder noise. `factors`,
/// if not empty, are the weights of a robust fit, one per reading. Empty if the model cannot be evaluated; throws
/// WorkStopped if stopped.
[[nodiscard]] std::optional<ReadingWeights> weighReadings(const PlacedArm& placed,
                                                          const std::vector<Measurement>& readings,
                                                          const Eigen::VectorXd& factors = {}, double model_error = 0,
                                                          const StopQuestion& stop = {});

/// Returns the weights recomputed for another model error and other robust factors.
[[nodiscard]] ReadingWeights reweighted(const ReadingWeights& weights, const std::vector<Measurement>& readings,
                                        double model_error, const Eigen::VectorXd& factors = {});

struct WhitenedResidual {
  bool ok = false;
  Eigen::VectorXd r;         ///< whitened residual, predicted minus measured, with the rows of ReadingWeights
  Eigen::MatrixXd jacobian;  ///< Jacobian with respect to the unknowns' variables, if requested
  /// Unwhitened residual, predicted minus measured [m]; for an unknown point, relative to its estimate.
  Eigen::VectorXd error;
};

/// Returns the residual at the variables x of the unknowns, relative to the state `start`; throws WorkStopped if
/// stopped.
[[nodiscard]] WhitenedResidual whitenedResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                                const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                                const Eigen::VectorXd& x, bool with_jacobian,
                                                const StopQuestion& stop = {});

/// Removes what several readings share from `columns`, which have the rows of `weights` and are whitened reading by
/// reading: noise of encoders that were read once, and the components that unknown points absorb.
void takeSharedOff(const ReadingWeights& weights, Eigen::Ref<Eigen::MatrixXd> columns);

/// Removes shared parts as takeSharedOff() does, but from the stacked rows of these readings alone; parts shared with
/// other readings remain.
void takeOffWithin(const ReadingWeights& weights, const std::vector<int>& readings, Eigen::MatrixXd& rows);

/// Returns the length of each reading's error [m].
[[nodiscard]] Eigen::VectorXd errorLengths(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                           const Eigen::VectorXd& error);

/// Returns the root mean square of the readings' errors if every row had an error of 1: the square root of the mean
/// number of rows per reading.
[[nodiscard]] double lengthOfRows(const std::vector<Measurement>& readings);

/// Returns the rms error due to noise alone: the root mean square over the readings of the error's length [m], after
/// the touched points have been estimated.
[[nodiscard]] double noiseFloor(const std::vector<Measurement>& readings, const ReadingWeights& weights);

}  // namespace tubeplan::calibration
