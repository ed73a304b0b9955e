// Verdict on a calibrated base before its use: the fit of the touches, and the distance of the base from its nominal
// place.
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
  bool fit_is_off = false;      ///< true if chi-square rejects the fit at the stated noise
  bool is_implausible = false;  ///< true if the base is further from nominal than expected
  double distance = std::numeric_limits<double>::quiet_NaN();  ///< distance of the base's origin from nominal [m]
  double angle = std::numeric_limits<double>::quiet_NaN();     ///< rotation of the base from nominal [rad]
  /// Shift along and across the sheet's x and y, in pitches; NaN without a sheet.
  Eigen::Vector2d pitches = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<std::string> warnings;  ///< one sentence each
  std::vector<std::string> to_do;     ///< remedies, one sentence each
};

/// Judges a base against `cell` before the calibration, whose base is the nominal one. Judges a refused base by its
/// touches alone.
[[nodiscard]] BaseVerdict judgeBase(const calibration::BaseCalibration& base, const Cell& cell);

/// Returns {verdict: adequate | falls-short, warnings, to_do, nominal: {shift, turn, distance, angle, pitches,
/// implausible}}; without `nominal` for a refused base.
[[nodiscard]] nlohmann::json baseVerdictJson(const BaseVerdict& verdict, const calibration::BaseCalibration& base,
                                             const Units& units);

}  // namespace tubeplan::app
