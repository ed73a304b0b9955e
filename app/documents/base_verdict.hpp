// What a person should look at before a calibrated base is used: whether the touches fit, and how far the base stands
// from where it should.
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
  bool fit_is_off = false;      ///< chi-square refuses the fit at the stated noise
  bool is_implausible = false;  ///< the base stands further from nominal than is to be expected
  double distance = std::numeric_limits<double>::quiet_NaN();  ///< m, of the base's origin from nominal
  double angle = std::numeric_limits<double>::quiet_NaN();     ///< rad, of its turn
  /// Along and across the sheet's x and y, in pitches; not numbers without a sheet.
  Eigen::Vector2d pitches = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<std::string> warnings;  ///< a sentence each
  std::vector<std::string> to_do;     ///< what to do about them, a sentence each
};

/// Judges a base against `cell` as it was before, its base the nominal one; of one that was refused, its touches alone.
[[nodiscard]] BaseVerdict judgeBase(const calibration::BaseCalibration& base, const Cell& cell);

/// {verdict: adequate | falls-short, warnings, to_do, nominal: {shift, turn, distance, angle, pitches, implausible}};
/// without `nominal` for a base that was refused.
[[nodiscard]] nlohmann::json baseVerdictJson(const BaseVerdict& verdict, const calibration::BaseCalibration& base,
                                             const Units& units);

}  // namespace tubeplan::app
