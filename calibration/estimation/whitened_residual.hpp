// Whitened residual of all measurements of a measurement campaign, of any kind and in any number of set-ups. Touched
// points of unknown position are eliminated exactly.
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

/// Rows of each measurement, their weights, and the groups of measurements that touched the same unknown point.
///
/// Elimination: touches of an unknown point P have the residuals W_i (p_i - P), where W_i is the whitener and p_i the
/// predicted tip. Let Q be an orthonormal basis of the stacked W_i. With the best P, the residual is (I - Q Q^T) W p,
/// so that the point costs 3 degrees of freedom but adds no variable. For a touched surface, the stacked rows are W_i
/// C_i, where C_i is the measurement's derivative with respect to the surface's parameters. Undetermined directions
/// cost no degree of freedom.
struct MeasurementWeights {
  struct UnknownPoint {
    std::string name;
    std::vector<int> measurements;
    /// Basis: one row per row of the point's measurements, at most one column per parameter of the place.
    Eigen::MatrixXd Q;
    Eigen::MatrixXd estimate;  ///< matrix that maps the stacked errors to the parameters of the place
  };
  std::vector<int> first_row;  ///< index of the first row of each measurement
  /// L^-1 of each measurement's own covariance L L^T, times the square root of its robust weight factor.
  std::vector<Eigen::MatrixXd> whitener;
  std::vector<Eigen::MatrixXd> noise;  ///< covariance of each measurement due to its own noise and encoder noise [m^2]
  /// Covariance of each measurement without the part shared with other measurements [m^2].
  std::vector<Eigen::MatrixXd> own_noise;
  /// C_i of each measurement; empty for measurements that touch no unknown point or surface.
  std::vector<Eigen::MatrixXd> by_place_numbers;
  std::vector<SharedNoise> shared;
  double model_error = 0;  ///< standard deviation of the model error of each coordinate, added to every covariance [m]
  std::vector<UnknownPoint> points;
  int rows = 0;
  int degrees_of_freedom = 0;  ///< number of rows minus the degrees of freedom that unknown points and surfaces cost

  /// Returns the covariance of one measurement [m^2], which is the sum of its noise and the model error.
  [[nodiscard]] Eigen::MatrixXd covariance(std::size_t measurement) const;
};

/// Returns the weights of the measurements from their covariances, which include the effect of encoder noise at the
/// state `placed`. `factors`, if not empty, are the weight factors of a robust fit, one per measurement. Empty if the
/// model cannot be evaluated; throws WorkStopped if a stop is requested.
[[nodiscard]] std::optional<MeasurementWeights> weighMeasurements(const PlacedArm& placed,
                                                                  const std::vector<Measurement>& measurements,
                                                                  const Eigen::VectorXd& factors = {},
                                                                  double model_error = 0,
                                                                  const StopQuestion& stop = {});

/// Returns `weights` recomputed for another model error and other robust weight factors, with the same noise.
[[nodiscard]] MeasurementWeights reweighted(const MeasurementWeights& weights,
                                            const std::vector<Measurement>& measurements, double model_error,
                                            const Eigen::VectorXd& factors = {});

struct WhitenedResidual {
  bool ok = false;
  Eigen::VectorXd r;         ///< whitened residual, predicted minus measured; its rows are those of MeasurementWeights
  Eigen::MatrixXd jacobian;  ///< Jacobian of r with respect to the variables of the unknowns, if requested
  /// Residual before whitening, predicted minus measured [m]; for touches of an unknown point, relative to its
  /// estimate.
  Eigen::VectorXd error;
};

/// Returns the residual at the values x of the unknowns' variables, which are 0 at `start`; throws WorkStopped if a
/// stop is requested.
[[nodiscard]] WhitenedResidual whitenedResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                                const std::vector<Measurement>& measurements,
                                                const MeasurementWeights& weights, const Eigen::VectorXd& x,
                                                bool with_jacobian, const StopQuestion& stop = {});

/// Completes the whitening of `columns`, whose rows are those of `weights`, already whitened measurement by
/// measurement: removes the correlation due to shared encoder noise, and the components that unknown points absorb.
void removeSharedParts(const MeasurementWeights& weights, Eigen::Ref<Eigen::MatrixXd> columns);

/// Like removeSharedParts(), for a matrix that stacks only the rows of these measurements. Parts shared with other
/// measurements are not removed.
void removeSharedPartsWithin(const MeasurementWeights& weights, const std::vector<int>& measurements,
                             Eigen::MatrixXd& rows);

/// Returns the Euclidean norm of each measurement's error over its rows [m].
[[nodiscard]] Eigen::VectorXd errorLengths(const std::vector<Measurement>& measurements,
                                           const MeasurementWeights& weights, const Eigen::VectorXd& error);

/// Returns the square root of the mean number of rows per measurement: this is the rms of the measurements' error
/// lengths if every row has an error of 1.
[[nodiscard]] double lengthOfRows(const std::vector<Measurement>& measurements);

/// Returns the expected rms of the measurements' error lengths [m] if noise is the only error, after touched points of
/// unknown position have been estimated.
[[nodiscard]] double noiseFloor(const std::vector<Measurement>& measurements, const MeasurementWeights& weights);

}  // namespace tubeplan::calibration
