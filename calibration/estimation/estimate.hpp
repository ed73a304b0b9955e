// Estimate of the free parameters from the measurements made so far, as the start for choosing further measurements.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/arm_uncertainty.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Sources of uncertainty in addition to the free parameters and the noise of the measurements.
struct AdditionalUncertainty {
  ArmUncertainty arm = ArmUncertainty::none();  ///< uncertainty of the arm's parameters that are not free
  double model_error = 0;  ///< standard deviation of the model error per coordinate, known beforehand [m]
};

/// Values and uncertainty of the free parameters, given the measurements made so far. The prior sigma of every
/// parameter is at most its typical size (Unknown::typical), so that the sigma is finite even if the measurements do
/// not determine it.
struct Estimate {
  /// Reasons why names cannot be freed; if there are any, the other members are invalid.
  std::vector<FreeProblem> problems;
  /// Reason why the measurements could not be fitted; the parameters then keep their values from the arm's file.
  std::string note;
  PlacedArm start;
  std::vector<Unknown> unknowns;
  Eigen::VectorXd x;  ///< fitted values of the unknowns' variables, relative to `start`
  /// Standard deviation of the model error of each coordinate, in addition to the measurements' noise [m].
  double model_error = 0;
  UncertainNumbers nuisance_parameters;  ///< uncertain parameters of the arm that are not free
  /// Information matrix. Its variables are those of `unknowns`, each divided by its typical size, then the standard
  /// normal variables of `nuisance_parameters`.
  Eigen::MatrixXd information;
};

/// Fits the measurements, except held-out ones, and adds up their information; there may be no measurements. If only a
/// base is free and the measurements are touches of known holes, the base is fitted as by calibrateBase(), together
/// with the uncertain parameters of `additional`. In all other cases, these parameters are treated as exact.
[[nodiscard]] Estimate estimateFrom(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                                    const std::vector<Measurement>& measurements, const FreeChoice& free,
                                    const AdditionalUncertainty& additional = {});

/// Returns the placed arm with the estimated parameter values.
[[nodiscard]] PlacedArm placedAsEstimated(const Estimate& estimate);

/// Returns the whitened Jacobian of the measurements with respect to the variables of Estimate::information; empty if
/// the arm's deflected shape does not converge at a measurement.
[[nodiscard]] std::optional<Eigen::MatrixXd> sensitivityOf(const Estimate& estimate,
                                                           const std::vector<Measurement>& measurements,
                                                           const MeasurementWeights& weights);

/// Returns, for each posture, the 3 x n Jacobian of the tip position in the world frame [m] with respect to the n
/// variables of Estimate::information, for the last base pose. The arm's deflected shape must converge at every
/// posture.
[[nodiscard]] std::vector<Eigen::MatrixXd> tipSensitivities(const Estimate& estimate,
                                                            const std::vector<Eigen::VectorXd>& postures, double load);

}  // namespace tubeplan::calibration
