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

/// Returns one sentence for each neighbouring hole with which the touches would fit, if it replaced the named hole;
/// best fit first. The fits allow for the usual model error (`model_sigma`). `chi2` is the chi-square of a fit to the
/// touches as given, with the same model error.
[[nodiscard]] std::vector<std::string> findMistakenHoles(const TouchesToExplain& to_explain, double chi2);

/// Single touch that does not fit the others: without it, the other touches fit. Its index is -1 unless there are at
/// least four touches and exactly one such touch. Also the rms error of the others in that fit [m].
struct OutlierTouch {
  int touch = -1;
  double rms_of_others = kNotKnown;
};
[[nodiscard]] OutlierTouch findOutlierTouch(const TouchesToExplain& to_explain);

/// Returns the joint readings that, if any one of them is corrected, make all touches fit: at most three, likeliest
/// first.
[[nodiscard]] std::vector<SuspectMeasurement> findSuspectMeasurements(const TouchesToExplain& to_explain);

}  // namespace tubeplan::calibration
