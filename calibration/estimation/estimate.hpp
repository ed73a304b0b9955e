// Information on the free parameters that the readings made so far give, and to which further readings add.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/arm_uncertainty.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Uncertainty beyond the free parameters and the readings' own noise.
struct DoubtBeside {
  ArmUncertainty arm = ArmUncertainty::none();  ///< uncertainty of the arm's parameters that are not free
  double model_error = 0;  ///< standard deviation of the model error per coordinate, known beforehand [m]
};

/// Present knowledge of the model: values and uncertainty of the free parameters. Every parameter has a prior with a
/// sigma of its typical size (Unknown::typical) at most, so that undetermined parameters have a sigma too.
struct Estimate {
  std::vector<FreeProblem> problems;  ///< reasons why names cannot be freed; if any, the other members are invalid
  std::string note;  ///< reason why the readings could not be fitted; parameters then keep the values of the arm's file
  PlacedArm start;
  std::vector<Unknown> unknowns;
  Eigen::VectorXd x;  ///< fitted values of the unknowns' variables, relative to `start`
  /// Standard deviation of the model error of each coordinate, in addition to the readings' noise [m].
  double model_error = 0;
  UncertainNumbers beside;  ///< uncertain parameters of the arm that are not free
  /// Information matrix of the variables divided by their typical sizes, then of the standard normal variables of
  /// `beside`.
  Eigen::MatrixXd information;
};

/// Fits the readings (there may be none; held-out readings are not used) and sums up their information. If only a base
/// is free and the readings are touches of known holes, the base is fitted as by calibrateBase(), together with the
/// uncertain parameters of `doubt`. In all other cases, these parameters count as exact.
[[nodiscard]] Estimate estimateFrom(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                                    const std::vector<Measurement>& readings, const FreeChoice& free,
                                    const DoubtBeside& doubt = {});

/// Returns the placed arm with the estimated parameter values.
[[nodiscard]] PlacedArm placedAsEstimated(const Estimate& estimate);

/// Returns the whitened Jacobian of the readings with respect to the variables of Estimate::information; empty if a
/// shape does not converge.
[[nodiscard]] std::optional<Eigen::MatrixXd> sensitivityOf(const Estimate& estimate,
                                                           const std::vector<Measurement>& readings,
                                                           const ReadingWeights& weights);

/// Returns the Jacobian of the tip in the world frame [m] with respect to the variables of Estimate::information: a 3 x
/// n matrix per posture, for the arm at its latest base pose. Every posture's shape must converge.
[[nodiscard]] std::vector<Eigen::MatrixXd> tipSensitivities(const Estimate& estimate,
                                                            const std::vector<Eigen::VectorXd>& postures, double load);

}  // namespace tubeplan::calibration
