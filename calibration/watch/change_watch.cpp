#include "calibration/watch/change_watch.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/watch/change_tests.hpp"

namespace tubeplan::calibration {

namespace {

/// Numbers of measurements before the estimated start of a change at which starts are tried if there are counts. The
/// judgement refines them.
constexpr int kEarlierStarts[] = {3, 6, 12, 24};
constexpr const char* kCountsTest = "counts";

class ChangeWatch {
 public:
  ChangeWatch(const RowsAndCandidates& watched, const WatchOptions& options)
      : watched_(watched),
        options_(options),
        planned_(std::max(watched.rows.count(), options.planned)),
        share_(options.false_alarms / testsOf(watched.rows)),
        filter_(watched.rows),
        measured_(watched, share_, planned_),
        counts_(planned_) {}

  Watch watch() {
    Watch result;
    result.status = WatchStatus::kQuiet;
    result.candidates = static_cast<int>(watched_.candidates.list.size());
    result.not_seen = watched_.candidates.not_seen;
    for (int k = 0; k < watched_.rows.count() && !result.alarm; ++k) {
      throwIfStopped(options_.stop);
      const TestedLevel nearest = testAfter(k);
      result.level.push_back(nearest.level);
      ++result.tested;
      if (nearest.level > 1) result.alarm = alarmAt(k, nearest);
    }
    if (!result.alarm) {
      result.detectable = detectableShift(watched_, filter_.state(), share_, planned_);
      return result;
    }
    result.status = WatchStatus::kAlarm;
    judge(*result.alarm);
    return result;
  }

  /// Returns the errors of base and parameters before a tested measurement.
  [[nodiscard]] const ErrorState& stateBefore(int k) const { return states_[static_cast<std::size_t>(k)]; }

 private:
  static int testsOf(const WatchedRows& rows) {
    const auto counted = std::ranges::count_if(rows.counted, [](const auto& count) { return count.has_value(); });
    return (counted > 0 ? 1 : 0) + (counted < rows.count() ? 3 : 0);
  }

  TestedLevel testAfter(int k) {
    states_.push_back(filter_.state());
    const CountChances chances = filter_.add(k);
    TestedLevel nearest = measured_.add(k);
    if (!watched_.rows.isCounted(k)) return nearest;
    const double log_ratio = counts_.add(k, chances);
    if (const double level = log_ratio / -std::log(share_); level > nearest.level)
      nearest = {kCountsTest, level, counts_.since(), 2 * log_ratio, 0};
    return nearest;
  }

  static WatchAlarm alarmAt(int measurement, const TestedLevel& by) {
    WatchAlarm alarm;
    alarm.measurement = measurement;
    alarm.since = by.since;
    alarm.test = by.test;
    alarm.chi2 = by.chi2;
    alarm.degrees_of_freedom = by.degrees_of_freedom;
    return alarm;
  }

  /// Returns the measurements that are tried as the first one after the change.
  [[nodiscard]] std::vector<int> startsOf(const WatchAlarm& alarm) const {
    std::vector<int> starts{alarm.since};
    if (watched_.rows.hasCounts()) {
      starts.insert(starts.end(), {(alarm.since + alarm.measurement) / 2, alarm.measurement});
      for (const int before : kEarlierStarts) starts.push_back(std::max(0, alarm.since - before));
    } else {
      for (const int before : startsBefore(alarm.measurement)) starts.push_back(before + 1);
    }
    std::vector<int> once;
    for (const int start : starts)
      if (std::ranges::find(once, start) == once.end()) once.push_back(start);
    return once;
  }

  /// Judges the change by all measurements since its start, including those after the alarm.
  void judge(WatchAlarm& alarm) {
    alarm.judged_to = std::min(watched_.rows.count() - 1, alarm.measurement + options_.judged_after);
    alarm.judgement = judgeChange(watched_, states_, startsOf(alarm), alarm.judged_to, options_.stop);
    const auto& answers = alarm.judgement.answers;
    if (answers.empty()) return;
    alarm.since = answers.front().since;
    alarm.kind = answers.size() > 1                     ? ChangeKind::kSeveral
                 : answers.front().effect == kBaseMoved ? ChangeKind::kBaseStep
                                                        : ChangeKind::kNamed;
  }

  const RowsAndCandidates& watched_;
  const WatchOptions& options_;
  int planned_;
  double share_;  // probability with which one test may raise a false alarm
  StateFilter filter_;
  MeasuredTests measured_;
  CountWatch counts_;
  std::vector<ErrorState> states_;  // filter state before each measurement
};

}  // namespace

Watch watchForChange(const WatchedArm& watched, const std::vector<Measurement>& measurements,
                     const WatchOptions& options) {
  return unlessStopped<Watch>(&Watch::status, WatchStatus::kStopped, [&] {
    const RowsAndCandidates rows = watchedRows(watched, measurements, options.stop);
    Watch watch;
    watch.status = WatchStatus::kNotComputed;
    watch.reason = rows.rows.reason;
    if (!watch.reason.empty()) return watch;
    ChangeWatch changes(rows, options);
    watch = changes.watch();
    if (watch.alarm && options.finds_means) {
      WatchAlarm& alarm = *watch.alarm;
      const std::vector<Measurement> since(measurements.begin() + alarm.since,
                                           measurements.begin() + alarm.judged_to + 1);
      alarm.means =
          separatingMeans(watched, since, changes.stateBefore(alarm.since), alarm.judgement.answers, options.stop);
    }
    return watch;
  });
}

}  // namespace tubeplan::calibration
