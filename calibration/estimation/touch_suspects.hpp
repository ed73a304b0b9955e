// Search for the error that prevents touches from fitting any base: a hole mistaken for its neighbour, a single wrong
// touch, or a wrong joint reading.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::calibration {

/// Touches whose lack of fit is to be explained, and the settings of their fit.
struct TouchesToExplain {
  const deflection::Arm& arm;
  const UncertainNumbers& numbers;
  const std::vector<Measurement>& touches;
  const Eigen::Isometry3d& X_WB;  ///< start of the fits, near the true base pose
  const BaseCalibrationOptions& options;
};

/// For each neighbouring hole that makes the touches fit if it replaces the named hole, returns a sentence that says
/// so, best fit first. The fits allow for the usual model error (`model_sigma`). `chi2` is that of a fit to the touches
/// as stated, with the same model error.
[[nodiscard]] std::vector<std::string> findMistakenHoles(const TouchesToExplain& asked, double chi2);

/// The touch without which the others fit, if there is exactly one such touch among at least four (otherwise -1), and
/// the rms error of the others without it [m].
struct OddTouch {
  int touch = -1;
  double rms_of_others = kNotKnown;
};
[[nodiscard]] OddTouch findOddTouch(const TouchesToExplain& asked);

/// Returns the joint readings that, if any one of them is corrected, make all touches fit: at most three, likeliest
/// first.
[[nodiscard]] std::vector<SuspectMeasurement> findSuspectMeasurements(const TouchesToExplain& asked);

}  // namespace tubeplan::calibration
