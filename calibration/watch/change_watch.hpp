// Watch over a calibrated arm at work: tells from the measurements of its visits when the model ceased to hold, since
// when, and which changes explain it.
//
// Before a change, the whitened residuals of the measurements are e = H x + noise of unit variance, where x is the
// error of base and parameters with the covariance P of the calibration. Tests after every measurement k, for changes
// after an earlier measurement s:
//   - the generalised likelihood ratio of a step of the base since s, with base, parameters and step unknown together
//     (Willsky and Jones 1976);
//   - the same ratio for every other candidate change (candidate_changes.hpp);
//   - the sum of squared innovations since s, in which any change of measured values shows;
//   - the ratio of the probabilities of the counts of steps (state_filter.hpp).
// The first three have chi-square distributions as long as nothing changes. The limit of each is the value that is
// exceeded with a probability of its share of the allowed false alarms divided by the number of its tests (Bonferroni),
// so that correlated tests only make false alarms rarer. The last has a bound of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/watch/detectable_shift.hpp"
#include "calibration/watch/separating_means.hpp"

namespace tubeplan::calibration {

struct WatchOptions {
  double false_alarms = 0.05;  ///< largest probability of an alarm over all planned measurements if nothing changes
  int planned = 0;  ///< number of measurements planned; if less than the number of measurements, the latter counts
  int judged_after = 30;    ///< largest number of measurements after an alarm that help to judge what has changed
  bool finds_means = true;  ///< true: looks for measurements that would tell the answers apart
  StopQuestion stop;
};

enum class WatchStatus { kNotRun, kQuiet, kAlarm, kNotComputed, kStopped };
enum class ChangeKind {
  kBaseStep,  ///< only a displacement of the base explains the measurements since the change
  kNamed,     ///< only one other candidate explains them
  kSeveral,   ///< several candidates explain them, which these measurements cannot tell apart
  kOther,     ///< no candidate explains them
};

struct WatchAlarm {
  int measurement = 0;         ///< index of the measurement at which the alarm was raised
  int since = 0;               ///< index of the first measurement after the change, as estimated
  std::string test;            ///< name of the test that raised the alarm
  double chi2 = 0;             ///< statistic that exceeded its limit; for counts, twice the log of the ratio
  int degrees_of_freedom = 0;  ///< of the statistic; 0 for counts
  ChangeKind kind = ChangeKind::kOther;
  int judged_to = 0;  ///< index of the last measurement that `judgement` takes into account
  ChangeJudgement judgement;
  std::optional<SeparatingMeans> means;  ///< what would tell the answers apart, if there are several
};

struct Watch {
  WatchStatus status = WatchStatus::kNotRun;
  std::string reason;                 ///< why nothing could be computed; empty otherwise
  std::optional<WatchAlarm> alarm;    ///< the first alarm; later measurements are not tested
  int tested = 0;                     ///< number of measurements that were tested
  int candidates = 0;                 ///< number of candidate changes that the measurements could show
  std::vector<std::string> not_seen;  ///< candidates that these measurements cannot show at all
  /// Sudden shifts of the base along x, y and z [m] that the latest measurements would probably have shown
  /// (detectable_shift.hpp), if the watch is quiet; infinite: not at all.
  Eigen::Vector3d detectable = Eigen::Vector3d::Constant(kNotKnown);
  /// Largest statistic after each tested measurement, as a fraction of its limit; above 1: alarm.
  std::vector<double> level;
};

/// Watches the measurements in their order, up to the first alarm; the measurements after it serve to judge what has
/// changed. All measurements must belong to one set-up and measure known points or places.
[[nodiscard]] Watch watchForChange(const WatchedArm& watched, const std::vector<Measurement>& measurements,
                                   const WatchOptions& options = {});

}  // namespace tubeplan::calibration
