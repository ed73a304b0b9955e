// Parser of clock times.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// Order of day and month in dates that end with the year.
enum class DateOrder { kDayFirst, kMonthFirst };

/// Returns the name of an order for the option --dates: "day-first" or "month-first".
[[nodiscard]] const char* nameOf(DateOrder order);

/// Returns the seconds of "2026-11-01 10:00:00.123" (or with a T between date and time), of "3/5/2024 11:50:00 AM", or
/// of "10:00:00" since midnight; std::nullopt for any other text. In dates with points the day comes first. Only
/// differences are meaningful: time zones and leap seconds are ignored.
[[nodiscard]] std::optional<double> clockSeconds(std::string_view text, DateOrder order = DateOrder::kMonthFirst);

/// Returns true if the text is a clock time in at least one order of day and month.
[[nodiscard]] bool isClockTime(std::string_view text);

/// Returns the orders of day and month in which all clock times among the rows are valid; only the first order if both
/// give the same differences between rows.
[[nodiscard]] std::vector<DateOrder> dateOrders(const std::vector<std::string>& rows);

/// Times of consecutive rows of a table.
struct ClockTimes {
  /// Time of each row [s], with days added after midnight; std::nullopt for a row without a valid time.
  std::vector<std::optional<double>> seconds;
  std::vector<std::size_t> midnights;  ///< indices of the first rows after a midnight
};

/// Returns the times of rows. A time without a date that is earlier than the previous one by half a day or more is on
/// the next day.
[[nodiscard]] ClockTimes clockTimes(const std::vector<std::string>& rows, DateOrder order = DateOrder::kMonthFirst);

}  // namespace tubeplan::app
