// Information on the free numbers from the readings so far, to which further readings add.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/arm_uncertainty.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Uncertainty of readings besides the free numbers and their own noise.
struct DoubtBeside {
  ArmUncertainty arm = ArmUncertainty::none();  ///< uncertainty of numbers that are not free
  double model_error = 0;                       ///< per coordinate, known beforehand [m]
};

/// Present knowledge of the model: values of its free numbers, and their uncertainty. Every number has a prior of its
/// typical size (Unknown::typical), so that undetermined ones have a sigma too.
struct Estimate {
  std::vector<FreeProblem> problems;  ///< reasons why the names cannot be freed; the rest is then not to be used
  std::string note;  ///< reason why the readings could not be fitted; the values are then those of the file
  PlacedArm start;
  std::vector<Unknown> unknowns;
  Eigen::VectorXd x;        ///< variables of the unknowns at the fit, from `start`
  double model_error = 0;   ///< error of each coordinate beyond the readings' noise (Identification::model_error) [m]
  UncertainNumbers beside;  ///< uncertain numbers of the arm that are not free
  /// Information on the variables over their typical sizes, then on the normals of `beside`.
  Eigen::MatrixXd information;
};

/// Fits the readings (any number, also none; held-out ones are not used) and adds up their information. Touches of
/// known holes that determine a base alone are fitted as `calibrate` does, with the doubt's numbers; for other readings
/// these count as exact.
[[nodiscard]] Estimate estimateFrom(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                                    const std::vector<Measurement>& readings, const FreeChoice& free,
                                    const DoubtBeside& doubt = {});

/// Returns the estimated arm, placed.
[[nodiscard]] PlacedArm placedAsEstimated(const Estimate& estimate);

/// Returns the sensitivity of weighted readings to each variable of the information; nothing if a shape does not
/// converge.
[[nodiscard]] std::optional<Eigen::MatrixXd> sensitivityOf(const Estimate& estimate,
                                                           const std::vector<Measurement>& readings,
                                                           const ReadingWeights& weights);

/// Returns the sensitivity of the tip in the world [m] to each variable of the information, a 3 x n matrix for each
/// posture, with the arm where it was placed last. Every posture's shape must converge.
[[nodiscard]] std::vector<Eigen::MatrixXd> tipSensitivities(const Estimate& estimate,
                                                            const std::vector<Eigen::VectorXd>& postures, double load);

}  // namespace tubeplan::calibration
