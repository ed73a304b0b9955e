// Watch over a calibrated arm at work: tells from the measurements of its visits when the model ceased to hold, since
// when, and whether a step of the base explains it.
//
// Before a change, the whitened residuals of the measurements are e = H x + noise of unit variance, where x is the
// error of base and parameters with the covariance P of the calibration. Two statistics are computed after every
// measurement k, for changes after an earlier measurement s:
//   - the generalised likelihood ratio of a step of the base since s, with base, parameters and step unknown together
//     (Willsky and Jones 1976);
//   - the sum of squared innovations since s, in which any change shows.
// Both have chi-square distributions as long as nothing changes. The limit of each is the value that is exceeded with a
// probability of the allowed false alarms divided by the number of all tests (Bonferroni), so that correlated tests
// only make false alarms rarer.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/touch_fit.hpp"
#include "calibration/hooks.hpp"

namespace tubeplan::calibration {

struct WatchOptions {
  double false_alarms = 0.05;  ///< largest probability of an alarm over all planned measurements if nothing changes
  int planned = 0;  ///< number of measurements planned; if less than the number of measurements, the latter counts
  StopQuestion stop;
};

/// The calibrated arm that is watched. `uncertainty` is that of base and parameters together, about X_WB and `arm`.
struct WatchedArm {
  const deflection::Arm& arm;
  Eigen::Isometry3d X_WB;
  const JointUncertainty& uncertainty;
  double model_error = 0;  ///< standard deviation of the model error of each coordinate [m]
};

enum class WatchStatus { kNotRun, kQuiet, kAlarm, kNotComputed, kStopped };
enum class ChangeKind {
  kUndecided,  ///< too few measurements since the change to tell a step of the base from anything else
  kBaseStep,   ///< a step of the base explains the measurements since the change
  kOther,      ///< a step of the base does not explain them
};

struct WatchAlarm {
  int measurement = 0;                       ///< index of the measurement at which the alarm was raised
  int since = 0;                             ///< index of the first measurement after the change, as estimated
  ChangeKind kind = ChangeKind::kUndecided;  ///< by the measurements up to the last one
  int judged_to = 0;                         ///< index of the last measurement that `kind` and `step` take into account
  double chi2 = 0;                           ///< statistic that exceeded its limit
  int degrees_of_freedom = 0;
  /// Step of the base that explains the measurements since the change best, with its standard deviations; see BaseStep.
  /// A component that these measurements do not determine has an infinite standard deviation.
  BaseStep step = BaseStep::Zero(), step_sigma = BaseStep::Zero();
};

struct Watch {
  WatchStatus status = WatchStatus::kNotRun;
  std::string reason;               ///< why nothing could be computed; empty otherwise
  std::optional<WatchAlarm> alarm;  ///< the first alarm; later measurements are not tested
  int tested = 0;                   ///< number of measurements that were tested
  /// Largest statistic after each tested measurement, as a fraction of its limit; above 1: alarm.
  std::vector<double> level;
};

/// Watches the measurements in their order, up to the first alarm; the measurements after it serve to judge what has
/// changed. All measurements must belong to one set-up and measure known points or places.
[[nodiscard]] Watch watchForChange(const WatchedArm& watched, const std::vector<Measurement>& measurements,
                                   const WatchOptions& options = {});

}  // namespace tubeplan::calibration
