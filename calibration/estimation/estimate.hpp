// What readings made so far determine of the free numbers, as information that further readings add to.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// The model as known: where its free numbers stand, and how well. Every number is taken as known beforehand to its
/// typical size (Unknown::typical), so that what no reading determines has a sigma too.
struct Estimate {
  std::vector<FreeProblem> problems;  ///< why the names cannot be freed; the rest is not to be used then
  std::string note;                   ///< why the readings could not be fitted: the drawing's values stand in then
  PlacedArm start;
  std::vector<Unknown> unknowns;
  Eigen::VectorXd x;            ///< variables of the unknowns at the fit, from `start`
  double model_error = 0;       ///< m, of each coordinate beyond the readings' noise (Identification::model_error)
  Eigen::MatrixXd information;  ///< of the variables over their typical sizes
};

/// Fits the readings (any number, also none; those held out are left alone) and counts what they determine.
[[nodiscard]] Estimate estimateFrom(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                                    const std::vector<Measurement>& readings, const FreeChoice& free);

/// The arm as known, placed.
[[nodiscard]] PlacedArm placedAsEstimated(const Estimate& estimate);

/// Sensitivity of the tip in the world [m] to each variable over its typical size, one 3 x n matrix for each posture,
/// the arm standing where it was placed last. Every posture's shape must converge.
[[nodiscard]] std::vector<Eigen::MatrixXd> tipSensitivities(const Estimate& estimate,
                                                            const std::vector<Eigen::VectorXd>& postures, double load);

}  // namespace tubeplan::calibration
