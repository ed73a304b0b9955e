// What readings made so far determine of the free numbers, as information that further readings add to.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/arm_uncertainty.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// What leaves readings uncertain beside the free numbers and their own noise.
struct DoubtBeside {
  ArmUncertainty arm = ArmUncertainty::none();  ///< of numbers that are not free
  double model_error = 0;                       ///< m per coordinate, as it is known beforehand
};

/// The model as known: where its free numbers stand, and how well. Every number is taken as known beforehand to its
/// typical size (Unknown::typical), so that what no reading determines has a sigma too.
struct Estimate {
  std::vector<FreeProblem> problems;  ///< why the names cannot be freed; the rest is not to be used then
  std::string note;                   ///< why the readings could not be fitted: the drawing's values stand in then
  PlacedArm start;
  std::vector<Unknown> unknowns;
  Eigen::VectorXd x;            ///< variables of the unknowns at the fit, from `start`
  double model_error = 0;       ///< m, of each coordinate beyond the readings' noise (Identification::model_error)
  UncertainNumbers beside;      ///< of the arm, which are not free
  Eigen::MatrixXd information;  ///< of the variables over their typical sizes, then of the normals of `beside`
};

/// Fits the readings (any number, also none; those held out are left alone) and counts what they determine. Touches of
/// known holes that find nothing but a base are fitted as `calibrate` does, the doubt's numbers beside it; other
/// readings are fitted as if these were exact.
[[nodiscard]] Estimate estimateFrom(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                                    const std::vector<Measurement>& readings, const FreeChoice& free,
                                    const DoubtBeside& doubt = {});

/// The arm as known, placed.
[[nodiscard]] PlacedArm placedAsEstimated(const Estimate& estimate);

/// Sensitivity of weighted readings to each variable of the information; nothing where a shape does not converge.
[[nodiscard]] std::optional<Eigen::MatrixXd> sensitivityOf(const Estimate& estimate,
                                                           const std::vector<Measurement>& readings,
                                                           const ReadingWeights& weights);

/// Sensitivity of the tip in the world [m] to each variable of the information, one 3 x n matrix for each posture, the
/// arm standing where it was placed last. Every posture's shape must converge.
[[nodiscard]] std::vector<Eigen::MatrixXd> tipSensitivities(const Estimate& estimate,
                                                            const std::vector<Eigen::VectorXd>& postures, double load);

}  // namespace tubeplan::calibration
