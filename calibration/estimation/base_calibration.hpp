// The base's pose from three or more touched holes (Calkins 1994, section 5.4; more than three as section 6.2
// suggests), with an update of the arm's own numbers.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/touch_fit.hpp"

namespace tubeplan::calibration {

/// A hole that a touch may have been mistaken for.
struct NeighbourHole {
  std::string name;
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();  ///< centre [m]
};
using NeighbourQuestion = std::function<std::vector<NeighbourHole>(const Measurement& touch)>;

struct BaseCalibrationOptions {
  ArmUncertainty arm;             ///< uncertainty of the numbers in the arm's file, which are fitted with the base
  double model_sigma = 7.62e-4;   ///< model error per coordinate [m] (0.030 in, the thesis's mean touch error)
  double collinear_ratio = 0.05;  ///< least height of the touches' triangle relative to its longest side
  double mistaken_hole_p_value = 1e-4;  ///< below it, a mistaken hole is searched for; 0: never
  NeighbourQuestion neighbours;   ///< neighbours of the hole that a touch names, for the search for a mistaken one
  double model_error = 0;         ///< model error known beforehand, per coordinate [m]
  bool finds_model_error = true;  ///< true: a lack of fit increases the model error
  bool finds_suspects = true;     ///< true: after a lack of fit, the touch or joint that explains it is searched for
  LeastSquaresMethod method = LeastSquaresMethod::kHybrid;
};

enum class CalibrationStatus { kNotRun, kDone, kRefused, kNotConverged };

struct TouchResidual {
  std::string id, hole;
  Eigen::Vector3d residual_W = Eigen::Vector3d::Zero();  ///< tip minus hole, for the fitted base and arm [m]
  Eigen::Vector3d sigma_W = Eigen::Vector3d::Zero();     ///< sigma of the reading itself [m]
};

/// Distance between two touched holes: by the arm of the file, and on the sheet. It does not depend on the base.
struct DistanceCheck {
  std::string from, to;
  double by_arm = 0, on_sheet = 0;  ///< [m]
  double sigma = 0;  ///< sigma of the difference, from the touches' noise and the arm's uncertain numbers [m]
};

/// A number of the arm that was fitted with the base.
struct TouchedNumber {
  std::string name;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double filed = 0, value = 0;      ///< value in the arm's file; fitted value
  double prior = 0, posterior = 0;  ///< standard deviations before and after the touches
};

/// A joint reading of one touch, with the error that would explain a lack of fit.
struct SuspectReading {
  std::string touch;
  Eigen::Index joint = -1;
  double off = 0;      ///< reading minus the value that the other touches require [rad or m]
  double p_value = 0;  ///< p-value of the touches with that correction
};

struct BaseCalibration : TouchedBase {
  CalibrationStatus status = CalibrationStatus::kNotRun;
  std::string reason;                  ///< why refused
  std::vector<std::string> suspects;   ///< "touch T2 named R10C20 fits R10C21"
  std::vector<TouchedNumber> numbers;  ///< that differ from the arm given
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Constant(kNotKnown);
  int odd_touch = -1;                ///< the one touch, of four or more that do not fit, without which the others do
  double rms_of_others = kNotKnown;  ///< m, then
  std::vector<SuspectReading> suspect_readings;  ///< where the touches do not fit, likeliest first
  std::vector<TouchResidual> residuals;
  std::vector<DistanceCheck> distances;
  double rms = kNotKnown;  ///< of the residuals' lengths [m]
  /// From where the search started, which is where the base should stand: shift [m], then rotation vector [rad], world
  /// axes.
  BaseStep from_start = BaseStep::Constant(kNotKnown);
};

/// Returns true if chi-square rejects the fit (p < 0.01): the arm deviates from its model beyond the uncertainty of its
/// numbers, or a touch has an error.
[[nodiscard]] bool isFitRefused(const BaseCalibration& calibration);

/// Finds the base by fitTouches(), from any start, from touches of known places of one set-up, each with its sigma. A
/// refused fit still has its residuals and possible errors of the touches.
[[nodiscard]] BaseCalibration calibrateBase(const deflection::Arm& arm, const std::vector<Measurement>& touches,
                                            const Eigen::Isometry3d& X_WB_start,
                                            const BaseCalibrationOptions& options = {});

/// Returns why these touches cannot place a base (fewer than three holes, one hole twice under the same load, near a
/// line); empty if they can.
std::string findTouchProblem(const std::vector<Measurement>& touches, const BaseCalibrationOptions& options = {});

}  // namespace tubeplan::calibration
