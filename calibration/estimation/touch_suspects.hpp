// Possible errors of touches that no base fits: a hole mistaken for its neighbour, a touch that does not belong to the
// others, a wrong joint reading.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::calibration {

/// Touches to explain, and the conditions of their fit.
struct TouchesToExplain {
  const deflection::Arm& arm;
  const UncertainNumbers& numbers;
  const std::vector<Measurement>& touches;
  const Eigen::Isometry3d& X_WB;  ///< base near which they are fitted
  const BaseCalibrationOptions& options;
};

/// Returns sentences on holes that, named instead of a neighbour, make the touches fit, best first. The model's usual
/// error is allowed for; `chi2` is that of the touches as they are, fitted in the same way.
[[nodiscard]] std::vector<std::string> findMistakenHoles(const TouchesToExplain& asked, double chi2);

/// The only touch, of four or more, without which the others fit, and their rms then [m]; -1 if there is none.
struct OddTouch {
  int touch = -1;
  double rms_of_others = kNotKnown;
};
[[nodiscard]] OddTouch findOddTouch(const TouchesToExplain& asked);

/// Returns the joint readings that, each corrected alone, make the touches fit, likeliest first.
[[nodiscard]] std::vector<SuspectReading> findSuspectReadings(const TouchesToExplain& asked);

}  // namespace tubeplan::calibration
