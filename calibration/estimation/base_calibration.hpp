// The base's pose from three or more touched holes (Calkins 1994, section 5.4; more than three as section 6.2 asks),
// with what the touches say of the arm's own numbers.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/touch_fit.hpp"

namespace tubeplan::calibration {

/// A hole that a touch may have been mistaken for.
struct NeighbourHole {
  std::string name;
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();  ///< m
};
using NeighbourQuestion = std::function<std::vector<NeighbourHole>(const Measurement& touch)>;

struct BaseCalibrationOptions {
  ArmUncertainty arm;  ///< of the numbers in the arm's file, which are found beside the base within it
  double model_sigma =
      7.62e-4;  ///< m per coordinate (0.030 in, the thesis's mean touch error): what the model may be off
  double collinear_ratio = 0.05;        ///< least height of the touches' triangle against its longest side
  double mistaken_hole_p_value = 1e-4;  ///< below it, touches are searched for a mistaken hole; 0: never
  NeighbourQuestion neighbours;         ///< of the hole that a touch names, for telling a mistaken one
  double model_error = 0;               ///< m, as in TouchFitOptions ...
  bool finds_model_error = true;        ///< ... and this too
  bool finds_suspects = true;           ///< whether a lack of fit is searched for the touch or joint that explains it
  LeastSquaresMethod method = LeastSquaresMethod::kHybrid;
};

enum class CalibrationStatus { kNotRun, kDone, kRefused, kNotConverged };

struct TouchResidual {
  std::string id, hole;
  Eigen::Vector3d residual_W = Eigen::Vector3d::Zero();  ///< tip minus hole, by the base and the arm as found [m]
  Eigen::Vector3d sigma_W = Eigen::Vector3d::Zero();     ///< of the reading itself
};

/// Distance between two touched holes: by the arm as its file has it, and on the sheet. Independent of the base.
struct DistanceCheck {
  std::string from, to;
  double by_arm = 0, on_sheet = 0;  ///< m
  double sigma = 0;                 ///< m, of the difference, by the touches' noise and the arm's uncertain numbers
};

/// A number of the arm beside which the touches were fitted.
struct TouchedNumber {
  std::string name;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double filed = 0, value = 0;      ///< in the arm's file; as the touches have it
  double prior = 0, posterior = 0;  ///< standard deviations before and after the touches
};

/// One joint reading of one touch which, were it off by so much, would explain a lack of fit.
struct SuspectReading {
  std::string touch;
  Eigen::Index joint = -1;
  double off = 0;      ///< rad or m: what was read less what the others ask for
  double p_value = 0;  ///< of the touches with it
};

struct BaseCalibration {
  CalibrationStatus status = CalibrationStatus::kNotRun;
  std::string reason;                 ///< why refused
  std::vector<std::string> suspects;  ///< "touch T2 named R10C20 fits R10C21"
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  deflection::Arm arm;                 ///< with its numbers as the touches have them: the one that stands at X_WB
  std::vector<TouchedNumber> numbers;  ///< that differ from the arm given
  JointUncertainty uncertainty;        ///< of base and numbers together
  Eigen::Matrix<double, 6, 6> covariance =
      Eigen::Matrix<double, 6, 6>::Constant(std::numeric_limits<double>::quiet_NaN());
  int odd_touch = -1;  ///< the one touch, of four or more that do not fit, without which the others do
  double rms_of_others = std::numeric_limits<double>::quiet_NaN();  ///< m, then
  std::vector<SuspectReading> suspect_readings;                     ///< where the touches do not fit, likeliest first
  std::vector<TouchResidual> residuals;
  std::vector<DistanceCheck> distances;
  double rms = std::numeric_limits<double>::quiet_NaN();   ///< of the residuals' lengths [m]
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< against the touches' noise and the numbers' uncertainty
  double p_value = std::numeric_limits<double>::quiet_NaN();
  double model_error = 0;             ///< m, of each coordinate beyond noise and numbers, as the covariance has it
  bool is_model_error_found = false;  ///< by these touches, which do not fit
  int degrees_of_freedom = 0;
  int iterations = 0;
  /// From where the search started, which is where the base should stand: shift [m], then rotation vector [rad], world
  /// axes.
  BaseStep from_start = BaseStep::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// Returns whether chi-square refuses the fit (p < 0.01): the arm does what neither its model nor the uncertainty of
/// its numbers allows, or a touch is not what it is said to be.
[[nodiscard]] bool isFitRefused(const BaseCalibration& calibration);

/// Finds the base by fitTouches(), from any start, by touches of known places of one set-up, each with its sigma. A fit
/// that is refused leaves its residuals and what may be wrong with the touches.
[[nodiscard]] BaseCalibration calibrateBase(const deflection::Arm& arm, const std::vector<Measurement>& touches,
                                            const Eigen::Isometry3d& X_WB_start,
                                            const BaseCalibrationOptions& options = {});

/// Why these touches cannot place a base (fewer than three holes, one hole twice under the same load, near a line), or
/// empty.
std::string findTouchProblem(const std::vector<Measurement>& touches, const BaseCalibrationOptions& options = {});

}  // namespace tubeplan::calibration
