// Change detection for a calibrated arm in service: determines from measurements of its visits whether and since when
// the model is no longer valid, and which changes explain it.
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
// so that correlated tests only make false alarms rarer. The limit of the last follows from Ville's inequality.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/watch/detectable_shift.hpp"
#include "calibration/watch/separating_means.hpp"

namespace tubeplan::calibration {

struct WatchOptions {
  double false_alarms = 0.05;  ///< largest probability of an alarm over all planned measurements if nothing changes
  int planned = 0;             ///< number of planned measurements; at least the number of given measurements is used
  int judged_after = 30;       ///< largest number of measurements after an alarm that are used to judge the change
  bool finds_means = true;     ///< true if measurements that discriminate between the answers are sought
  StopQuestion stop;
};

enum class WatchStatus { kNotRun, kQuiet, kAlarm, kNotComputed, kStopped };
enum class ChangeKind {
  kBaseStep,  ///< only a displacement of the base explains the measurements since the change
  kNamed,     ///< only one candidate other than the base explains the measurements
  kSeveral,   ///< several indistinguishable candidates explain the measurements
  kOther,     ///< no candidate explains the measurements
};

struct WatchAlarm {
  int measurement = 0;         ///< index of the measurement at which the alarm was raised
  int since = 0;               ///< index of the first measurement after the change, as estimated
  std::string test;            ///< name of the test that raised the alarm
  double chi2 = 0;             ///< statistic that exceeded its limit; for counts, twice the log of the ratio
  int degrees_of_freedom = 0;  ///< degrees of freedom of the statistic; 0 for counts
  ChangeKind kind = ChangeKind::kOther;
  int judged_to = 0;  ///< index of the last measurement that `judgement` takes into account
  ChangeJudgement judgement;
  std::optional<SeparatingMeans> means;  ///< measurements that discriminate between several answers
};

struct Watch {
  WatchStatus status = WatchStatus::kNotRun;
  std::string reason;                 ///< reason why there is no result; empty on success
  std::optional<WatchAlarm> alarm;    ///< the first alarm; later measurements are not tested
  int tested = 0;                     ///< number of measurements that were tested
  int candidates = 0;                 ///< number of candidate changes that the measurements could show
  std::vector<std::string> not_seen;  ///< candidates without any effect on these measurements
  /// Smallest steps of the base along x, y and z [m] that the latest measurements would probably have revealed
  /// (detectable_shift.hpp), if there is no alarm; infinite if no step would have been revealed.
  Eigen::Vector3d detectable = Eigen::Vector3d::Constant(kNotKnown);
  /// Largest statistic after each tested measurement, as a fraction of its limit; an alarm if above 1.
  std::vector<double> level;
};

/// Tests the measurements in order, up to the first alarm; later measurements are only used to judge the change.
/// All measurements must belong to one set-up and measure known points or places.
[[nodiscard]] Watch watchForChange(const WatchedArm& watched, const std::vector<Measurement>& measurements,
                                   const WatchOptions& options = {});

}  // namespace tubeplan::calibration
