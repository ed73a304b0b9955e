// Clock times in text form.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// Order of day and month in a date that ends with the year.
enum class DateOrder { kDayFirst, kMonthFirst };

/// Returns the name for --dates: "day-first", "month-first".
[[nodiscard]] const char* nameOf(DateOrder order);

/// Returns the seconds of "2026-11-01 10:00:00.123", also with a T between, of "3/5/2024 11:50:00 AM", or of "10:00:00"
/// since midnight; nothing for any other text. Dates with points have the day first. Only differences are meaningful:
/// zones and leap seconds are ignored.
[[nodiscard]] std::optional<double> clockSeconds(std::string_view text, DateOrder order = DateOrder::kMonthFirst);

/// Returns true for a clock time in either order of day and month.
[[nodiscard]] bool isClockTime(std::string_view text);

/// Returns the orders in which every row is valid that is a time in one of them; only the first if both give the same
/// differences.
[[nodiscard]] std::vector<DateOrder> dateOrders(const std::vector<std::string>& rows);

/// Times of consecutive rows.
struct ClockTimes {
  std::vector<std::optional<double>> seconds;  ///< seconds of each row by clockSeconds(), with days added
  std::vector<std::size_t> midnights;          ///< rows from which one more day is added
};

/// Returns the times of rows. A clock without a date that goes back by half a day or more has passed midnight.
[[nodiscard]] ClockTimes clockTimes(const std::vector<std::string>& rows, DateOrder order = DateOrder::kMonthFirst);

}  // namespace tubeplan::app
