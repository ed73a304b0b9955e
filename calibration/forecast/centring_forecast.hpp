// How far the tip of a fitted arm may be off, sideways, where it is sent to: by the covariance of what was fitted, and,
// apart, by the noise of the joints' readings at the goal. What the model lacks is not in it.
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
  double load = 0;   ///< N, hung on the tip at work
  int draws = 2000;  ///< of the fitted numbers from their covariance
  std::uint64_t seed = 1;
  /// Of a base that the fit took as known: shift [m], then turn [rad], world axes; none: it counts as exact.
  std::optional<Eigen::Matrix<double, 6, 6>> base_covariance;
};

/// A figure over the postures [m]: its median over the draws, and where it lies in 95 % of them.
struct ForecastFigure {
  double value = std::numeric_limits<double>::quiet_NaN();
  double lower = std::numeric_limits<double>::quiet_NaN();
  double upper = std::numeric_limits<double>::quiet_NaN();
};

/// Root mean square sideways error by the encoders' noise at the goal, over the postures [m].
struct EncoderShare {
  double median = std::numeric_limits<double>::quiet_NaN();
  double p95 = std::numeric_limits<double>::quiet_NaN();
  double worst = std::numeric_limits<double>::quiet_NaN();
};

enum class CentringForecastStatus { kNotRun, kDone, kNothingUncertain };

struct CentringForecast {
  CentringForecastStatus status = CentringForecastStatus::kNotRun;
  std::string reason;
  ForecastFigure median, p95, worst;  ///< half, 95 % and all of the postures have at most this error
  int worst_posture = -1;             ///< the one whose root mean square error is largest
  EncoderShare encoders;
  int numbers = 0;  ///< uncertain ones that are counted, those of the base included
};

/// Sideways is across the world's z, the axis of the holes. The arm stands where it was placed last. Linear in the
/// fitted numbers; one draw of them makes the errors of all postures together. Every posture's shape must converge.
[[nodiscard]] CentringForecast forecastCentring(const Identification& fit, const std::vector<Eigen::VectorXd>& postures,
                                                const CentringForecastOptions& options = {});

}  // namespace tubeplan::calibration
