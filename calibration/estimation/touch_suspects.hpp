// What may be wrong with touches that no base fits: a hole mistaken for its neighbour, a touch that does not belong to
// the others, a joint that was misread.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::calibration {

/// Touches that are to be explained, and how they are fitted.
struct TouchesToExplain {
  const deflection::Arm& arm;
  const UncertainNumbers& numbers;
  const std::vector<Measurement>& touches;
  const Eigen::Isometry3d& X_WB;  ///< near which they are fitted
  const BaseCalibrationOptions& options;
};

/// Returns sentences on holes that, named in place of a neighbour, make the touches fit, best first. The model's usual
/// error is allowed for; `chi2` is that of the touches as they are, fitted so.
[[nodiscard]] std::vector<std::string> findMistakenHoles(const TouchesToExplain& asked, double chi2);

/// The only touch, of four or more, without which the others fit, and their rms then [m]; -1 where there is none.
struct OddTouch {
  int touch = -1;
  double rms_of_others = std::numeric_limits<double>::quiet_NaN();
};
[[nodiscard]] OddTouch findOddTouch(const TouchesToExplain& asked);

/// Returns the joint readings that, each corrected by itself, make the touches fit, likeliest first.
[[nodiscard]] std::vector<SuspectReading> findSuspectReadings(const TouchesToExplain& asked);

}  // namespace tubeplan::calibration
