#include "calibration/measurement_checks/clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "calibration/measurement_checks/from_measurement.hpp"
#include "calibration/statistics.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::calibration {

namespace {

constexpr std::size_t kFewestTimes = 8;  // smallest number of times needed to decide whether the rows are in time order
// The rows are not in time order if more than this fraction of the measurements is earlier than the previous
// measurement.
constexpr double kMostBack = 0.05;
constexpr double kSlow = 3;        // gaps above this multiple of the usual gap are suspicious
constexpr double kHour = 3600;     // [s]
constexpr double kMostHours = 14;  // largest shift of a clock by time zones and daylight-saving time [h]
constexpr double kNearHour = 120;  // jumps are whole hours if they are this close [s], and closer than the usual gap
constexpr double kDay = 24 * kHour, kMonth = 30 * kDay;

double timeOf(const Measurement& measurement) { return measurement.conditions[deflection::Condition::kTime]; }

/// Returns the measurements that state a time.
std::vector<const Measurement*> timedAmong(const std::vector<Measurement>& measurements) {
  std::vector<const Measurement*> timed;
  for (const Measurement& measurement : measurements)
    if (std::isfinite(timeOf(measurement))) timed.push_back(&measurement);
  return timed;
}

/// Returns a duration as text: "45 s", "3 min", "2 h", "40 days".
std::string durationText(double seconds) {
  constexpr std::pair<double, const char*> kUnits[] = {{48 * kHour, "days"}, {kHour, "h"}, {60, "min"}};
  const double size = std::abs(seconds);
  for (const auto& [least, name] : kUnits)
    if (size >= least) return fmt::format("{:.3g} {}", size / std::min(least, 24 * kHour), name);
  return fmt::format("{:.3g} s", size);
}

/// Search for jumps in the times of measurements.
class Clock {
 public:
  explicit Clock(const std::vector<Measurement>& measurements) : timed_(timedAmong(measurements)) {
    std::vector<double> forward;
    for (std::size_t k = 1; k < timed_.size(); ++k) {
      if (gap(k) > 0) forward.push_back(gap(k));
      if (gap(k) < 0) back_.push_back(k);
    }
    if (!forward.empty()) usual_ = median(std::move(forward));
  }

  [[nodiscard]] bool isOrdered() const {
    const double most = std::max(2., kMostBack * static_cast<double>(timed_.size()));
    return timed_.size() >= kFewestTimes && usual_ > 0 && static_cast<double>(back_.size()) <= most;
  }

  [[nodiscard]] std::vector<MeasurementCheck> jumps() const {
    std::vector<MeasurementCheck> checks;
    for (const std::size_t k : back_) {
      if (const bool is_far = -gap(k) > kSlow * usual_; is_far && k + 1 < timed_.size() && time(k + 1) >= time(k - 1))
        checks.push_back(alone(k, "before"));
      else if (is_far && k >= 2 && time(k) >= time(k - 2))
        checks.push_back(alone(k - 1, "after"));
      else if (isMidnight(k))
        checks.push_back(midnightBefore(k));
      else
        checks.push_back(from(k, "back", "the clock was set there, or was restarted"));
    }
    if (const auto k = forward())
      checks.push_back(
          from(*k, "forward", "was the clock set there? If it was only a pause of that length, the times are right"));
    return checks;
  }

 private:
  [[nodiscard]] double time(std::size_t k) const { return timeOf(*timed_[k]); }
  [[nodiscard]] double gap(std::size_t k) const { return time(k) - time(k - 1); }

  /// Returns by how much gap `k` exceeds the usual gap [s], rounded to whole hours if it is close to them.
  [[nodiscard]] double jumpAt(std::size_t k) const {
    const double jump = gap(k) - usual_, rounded = std::round(jump / kHour) * kHour;
    const bool is_whole = rounded != 0 && std::abs(rounded) <= kMostHours * kHour &&
                          std::abs(jump - rounded) < std::min(usual_, kNearHour);
    return is_whole ? rounded : jump;
  }

  /// Returns the index of the only gap that is far longer than usual, if its excess is a whole number of hours or the
  /// gap exceeds a month. Returns nullopt otherwise, and if there are several long gaps, because some of them are then
  /// pauses.
  [[nodiscard]] std::optional<std::size_t> forward() const {
    std::vector<std::size_t> longest;
    for (std::size_t k = 1; k < timed_.size(); ++k)
      if (gap(k) > std::max(kSlow * usual_, kHour)) longest.push_back(k);
    if (longest.size() != 1) return std::nullopt;
    const std::size_t k = longest.front();
    // In this case, only measurement k has a wrong time.
    const bool is_of_next = k + 1 < timed_.size() && gap(k + 1) < 0;
    const bool is_set = jumpAt(k) != gap(k) - usual_ || gap(k) > kMonth;
    return is_set && !is_of_next ? std::optional(k) : std::nullopt;
  }

  [[nodiscard]] MeasurementCheck alone(std::size_t k, const char* side) const {
    return remark(fmt::format("the time of reading {} is {} those of both its neighbours, and no other time is out of "
                              "order: is it a typing error?",
                              timed_[k]->id, side),
                  "");
  }

  [[nodiscard]] MeasurementCheck from(std::size_t k, const char* way, const char* cause) const {
    return remark(fmt::format("at reading {} the time jumps {} by {}, while readings are usually {} apart: {}",
                              timed_[k]->id, way, durationText(jumpAt(k)), durationText(usual_), cause),
                  fmt::format("clock={:.6g}@{}", -jumpAt(k), timed_[k]->id));
  }

  /// Returns true if the times step back by one day, as on a clock without a date at midnight.
  [[nodiscard]] bool isMidnight(std::size_t k) const {
    return std::abs(gap(k) - usual_ + kDay) < std::min(usual_, kNearHour);
  }

  /// Returns the finding that the clock passed midnight and has no date, which is the usual cause of a step back by one
  /// day.
  [[nodiscard]] MeasurementCheck midnightBefore(std::size_t k) const {
    MeasurementCheck check = from(k, "back", "the clock passed midnight there and its times have no date");
    check.severity = CheckSeverity::kMistake;
    check.assume = fmt::format("clock={:.6g}@{}", kDay, timed_[k]->id);
    return check;
  }

  static MeasurementCheck remark(std::string sentence, std::string assume) {
    return {"clock", CheckSeverity::kRemark, std::move(sentence), kNoFigure, kNoFigure, std::move(assume), {}};
  }

  std::vector<const Measurement*> timed_;
  std::vector<std::size_t> back_;  ///< indices of measurements that have an earlier time than the preceding measurement
  double usual_ = 0;               ///< usual (median) gap between measurements [s]
};

}  // namespace

std::vector<MeasurementCheck> clockJumps(const CheckedMeasurements& checked) {
  const Clock clock(checked.measurements);
  return clock.isOrdered() ? clock.jumps() : std::vector<MeasurementCheck>{};
}

namespace mistakes::clock {

namespace {

std::optional<Correction> correctionOf(const CheckedMeasurements& checked, const std::string& text) {
  const auto [value, from] = partedAtMeasurement(text);
  const auto seconds = tubesheets::parseNumber(value);
  if (!seconds || !from) return std::nullopt;
  Correction correction{"clock", value, "the clock is off: " + value + " s to be added to the times"};
  correction.change = [by = *seconds](std::vector<Measurement>& measurements) {
    for (auto& measurement : measurements) measurement.conditions[deflection::Condition::kTime] += by;
  };
  return fromMeasurement(checked, std::move(correction), *from);
}

}  // namespace

MistakeKind kind() {
  return {.name = "clock",
          .value = "SECONDS@READING",
          .expected = "seconds to add to the times, and the first such reading, as in -3600@P41",
          .values = noValues,
          .correction = correctionOf};
}

}  // namespace mistakes::clock

}  // namespace tubeplan::calibration
