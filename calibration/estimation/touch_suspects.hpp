// Possible errors of touches that fit no base: a hole mistaken for its neighbour, an odd touch among the others, a
// wrong joint reading.
#pragma once

#include <string>
#include <vector>

#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::calibration {

/// Touches to explain, and the settings of their fit.
struct TouchesToExplain {
  const deflection::Arm& arm;
  const UncertainNumbers& numbers;
  const std::vector<Measurement>& touches;
  const Eigen::Isometry3d& X_WB;  ///< start of the touches' fits, near the base
  const BaseCalibrationOptions& options;
};

/// Returns a sentence for each neighbouring hole that makes the touches fit if it replaces the named hole, best first.
/// The fits allow for the usual model error (`model_sigma`). `chi2` is that of the touches as stated, fitted in the
/// same way.
[[nodiscard]] std::vector<std::string> findMistakenHoles(const TouchesToExplain& asked, double chi2);

/// The only touch, of four or more, without which the others fit (-1: none or several), and the rms of these others
/// [m].
struct OddTouch {
  int touch = -1;
  double rms_of_others = kNotKnown;
};
[[nodiscard]] OddTouch findOddTouch(const TouchesToExplain& asked);

/// Returns the joint readings of which a single correction makes all touches fit, at most three, likeliest first.
[[nodiscard]] std::vector<SuspectReading> findSuspectReadings(const TouchesToExplain& asked);

}  // namespace tubeplan::calibration
