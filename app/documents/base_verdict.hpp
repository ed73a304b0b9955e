// Verdict on a calibrated base before it is used: how well the touches fit, and how far the base is from its nominal
// pose.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::app {

struct BaseVerdict {
  bool fit_is_off = false;      ///< true if the chi-square test rejects the fit, given the stated noise
  bool is_implausible = false;  ///< true if the base is farther from nominal than its prior allows
  /// Distance of the base origin from nominal [m]; NaN if the calibration was refused.
  double distance = std::numeric_limits<double>::quiet_NaN();
  /// Rotation angle of the base from nominal [rad]; NaN if the calibration was refused.
  double angle = std::numeric_limits<double>::quiet_NaN();
  /// Shift of the base along the x and y axes of the sheet, in pitches; NaN without a sheet.
  Eigen::Vector2d pitches = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<std::string> warnings;  ///< one sentence per element
  std::vector<std::string> to_do;     ///< remedies, one sentence per element
};

/// Judges a calibrated base. `cell` is the cell before the calibration, with the nominal base. If the calibration was
/// refused, only the fit of its touches is judged.
[[nodiscard]] BaseVerdict judgeBase(const calibration::BaseCalibration& base, const Cell& cell);

/// Returns {verdict: adequate or falls-short, warnings, to_do, nominal: {shift, turn, distance, angle, pitches,
/// implausible}}; without `nominal` if the calibration was refused.
[[nodiscard]] nlohmann::json baseVerdictJson(const BaseVerdict& verdict, const calibration::BaseCalibration& base,
                                             const Units& units);

}  // namespace tubeplan::app
