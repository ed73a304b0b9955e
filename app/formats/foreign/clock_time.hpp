// Times as clocks write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// Which number of a date is the day, where the year stands last.
enum class DateOrder { kDayFirst, kMonthFirst };

/// "day-first", "month-first": as --dates takes them.
[[nodiscard]] const char* nameOf(DateOrder order);

/// Seconds of "2026-11-01 10:00:00.123", of the same with a T between, of "3/5/2024 11:50:00 AM", or of "10:00:00"
/// since midnight; nothing for any other text. Dates with points have the day first. Only differences mean anything:
/// zones and leap seconds are not known.
[[nodiscard]] std::optional<double> clockSeconds(std::string_view text, DateOrder order = DateOrder::kMonthFirst);

/// Returns whether a text is a clock time in either order of day and month.
[[nodiscard]] bool isClockTime(std::string_view text);

/// The orders in which every row that is a time in one of them is one; only the first where both mean the same times.
[[nodiscard]] std::vector<DateOrder> dateOrders(const std::vector<std::string>& rows);

/// Times of rows that follow one another.
struct ClockTimes {
  std::vector<std::optional<double>> seconds;  ///< of each row, as clockSeconds() gives them, days added
  std::vector<std::size_t> midnights;          ///< rows from which a day more is added
};

/// A clock without a date that goes back by half a day or more has passed midnight.
[[nodiscard]] ClockTimes clockTimes(const std::vector<std::string>& rows, DateOrder order = DateOrder::kMonthFirst);

}  // namespace tubeplan::app
