// Forecast of the lateral tip error of a fitted arm at its goals: from the covariance of the fit and, separately, from
// the noise of the joint readings at the goal. Effects that the model lacks are not included.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct CentringForecastOptions {
  double load = 0;   ///< load hung from the tip at the goals [N]
  int draws = 2000;  ///< number of draws of the fitted parameters from their covariance
  std::uint64_t seed = 1;
  /// Covariance of a base that the fit treated as known: shift [m], then rotation [rad], in world axes. If empty, the
  /// base is exact.
  std::optional<Eigen::Matrix<double, 6, 6>> base_covariance;
};

/// A statistic over the postures [m]: its median over the draws, and its 95 % interval.
struct ForecastFigure {
  double value = std::numeric_limits<double>::quiet_NaN();
  double lower = std::numeric_limits<double>::quiet_NaN();
  double upper = std::numeric_limits<double>::quiet_NaN();
};

/// Root mean square lateral error due to encoder noise at the goal: statistics over the postures [m].
struct EncoderShare {
  double median = std::numeric_limits<double>::quiet_NaN();
  double p95 = std::numeric_limits<double>::quiet_NaN();
  double worst = std::numeric_limits<double>::quiet_NaN();
};

enum class CentringForecastStatus { kNotRun, kDone, kNothingUncertain };

struct CentringForecast {
  CentringForecastStatus status = CentringForecastStatus::kNotRun;
  std::string reason;
  ForecastFigure median, p95, worst;  ///< median, 95th percentile and maximum of the error over the postures
  int worst_posture = -1;             ///< index of the posture with the largest root mean square error; -1 if none
  EncoderShare encoders;
  int numbers = 0;  ///< number of uncertain parameters, including those of the base
};

/// Forecasts the error perpendicular to the world's z axis, the axis of the holes, for the arm at its latest base pose.
/// The error is linear in the fitted parameters, and each draw of the parameters gives the errors of all postures
/// together. Every posture's shape must converge.
[[nodiscard]] CentringForecast forecastCentring(const Identification& fit, const std::vector<Eigen::VectorXd>& postures,
                                                const CentringForecastOptions& options = {});

}  // namespace tubeplan::calibration
