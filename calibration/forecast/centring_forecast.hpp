// Forecast of the lateral error of a fitted arm's tip at its goals: from the covariance of the fit and, separately,
// from the noise of the joints' readings at the goal. Errors missing from the model are not included.
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
  double load = 0;   ///< hung on the tip at work [N]
  int draws = 2000;  ///< draws of the fitted numbers from their covariance
  std::uint64_t seed = 1;
  /// Covariance of a base that the fit took as known: shift [m], then rotation [rad], world axes; nothing: it counts as
  /// exact.
  std::optional<Eigen::Matrix<double, 6, 6>> base_covariance;
};

/// A figure over the postures [m]: its median over the draws, and its 95 % interval.
struct ForecastFigure {
  double value = std::numeric_limits<double>::quiet_NaN();
  double lower = std::numeric_limits<double>::quiet_NaN();
  double upper = std::numeric_limits<double>::quiet_NaN();
};

/// Root mean square lateral error by the encoders' noise at the goal, over the postures [m].
struct EncoderShare {
  double median = std::numeric_limits<double>::quiet_NaN();
  double p95 = std::numeric_limits<double>::quiet_NaN();
  double worst = std::numeric_limits<double>::quiet_NaN();
};

enum class CentringForecastStatus { kNotRun, kDone, kNothingUncertain };

struct CentringForecast {
  CentringForecastStatus status = CentringForecastStatus::kNotRun;
  std::string reason;
  ForecastFigure median, p95, worst;  ///< errors that half, 95 % and all of the postures do not exceed
  int worst_posture = -1;             ///< the one with the largest root mean square error
  EncoderShare encoders;
  int numbers = 0;  ///< number of uncertain numbers included, with those of the base
};

/// Forecasts the error across the world's z, the axis of the holes, for the arm where it was placed last. It is linear
/// in the fitted numbers; one draw of them gives the errors of all postures together. Every posture's shape must
/// converge.
[[nodiscard]] CentringForecast forecastCentring(const Identification& fit, const std::vector<Eigen::VectorXd>& postures,
                                                const CentringForecastOptions& options = {});

}  // namespace tubeplan::calibration
