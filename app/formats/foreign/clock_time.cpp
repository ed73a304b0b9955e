#include "app/formats/foreign/clock_time.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>

#include "app/storage/lower_case.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

constexpr double kDay = 86400;  // length of a day [s]
constexpr std::array kDateOrders{DateOrder::kDayFirst, DateOrder::kMonthFirst};

/// Returns the separator in the date before a time, as in 2026-11-01, 3/5/2024 and 3.5.2024; std::nullopt if there is
/// no date.
std::optional<char> dateMark(std::string_view text) {
  const std::size_t at = text.substr(0, text.find(':')).find_first_of("-/.");
  return at == std::string_view::npos ? std::nullopt : std::optional(text[at]);
}

/// Removes a number and the separator after the number from the start of the text; returns the number, or std::nullopt
/// if there is none.
std::optional<int> takeNumber(std::string_view& text, std::string_view marks) {
  const std::size_t end = text.find_first_of(marks);
  if (end == std::string_view::npos || end == 0 || end > 4) return std::nullopt;
  const auto number = tubesheets::parseInteger(text.substr(0, end));
  text.remove_prefix(end + 1);
  return number && *number >= 0 ? number : std::nullopt;
}

/// Removes a date with a four-digit year from the start of the text; returns the date in days since 1970-01-01, or
/// std::nullopt if there is no valid date.
std::optional<double> takeDays(std::string_view& text, char mark, DateOrder order) {
  constexpr int kLeastYear = 1000;
  const std::string_view marks(&mark, 1);
  const auto first = takeNumber(text, marks), second = takeNumber(text, marks), third = takeNumber(text, " T");
  if (!first || !second || !third) return std::nullopt;
  int year = *first, month = *second, day = *third;
  if (*third >= kLeastYear && *first < kLeastYear) {
    const bool is_day_first = order == DateOrder::kDayFirst || mark == '.';
    year = *third;
    month = is_day_first ? *second : *first;
    day = is_day_first ? *first : *second;
  }
  constexpr int kMonths = 12,
                kMostDays = 31;  // limits for std::chrono::month and day, which truncate larger numbers to 8 bits
  if (month > kMonths || day > kMostDays) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  return static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

/// Removes AM or PM from the end of the text; returns 0 or 12, the hours to add on a 12-hour clock, or std::nullopt for
/// a 24-hour clock.
std::optional<int> takeHalf(std::string_view& text) {
  const std::string small = lowerCase(text);
  for (const auto& [word, hours] : {std::pair{"am", 0}, std::pair{"pm", 12}}) {
    if (!small.ends_with(word)) continue;
    text.remove_suffix(2);
    text = tubesheets::trimBlanks(text);
    return hours;
  }
  return std::nullopt;
}

/// Returns the hour of the day, 0 to 23; `half` is the result of takeHalf(). std::nullopt if the hour is invalid on a
/// 12-hour or 24-hour clock.
std::optional<int> hoursOf(int stated, const std::optional<int>& half) {
  if (!half) return stated <= 23 ? std::optional(stated) : std::nullopt;
  return stated >= 1 && stated <= 12 ? std::optional(stated % 12 + *half) : std::nullopt;
}

}  // namespace

const char* nameOf(DateOrder order) { return order == DateOrder::kDayFirst ? "day-first" : "month-first"; }

std::optional<double> clockSeconds(std::string_view text, DateOrder order) {
  double days = 0;
  const auto mark = dateMark(text);
  const auto half = takeHalf(text);
  if (mark) {
    const auto found = takeDays(text, *mark, order);
    if (!found) return std::nullopt;
    days = *found;
  }
  const auto stated = takeNumber(text, ":");
  const bool has_seconds = text.find(':') != std::string_view::npos;
  if (!stated || !(has_seconds || mark || half)) return std::nullopt;
  const auto hours = hoursOf(*stated, half);
  const auto minutes = has_seconds ? takeNumber(text, ":") : tubesheets::parseInteger(text);
  const auto seconds = has_seconds ? tubesheets::parseNumber(text) : std::optional(0.0);
  if (!hours || !minutes || !seconds || *minutes < 0 || *minutes > 59 || !(*seconds >= 0 && *seconds < 61))
    return std::nullopt;
  return kDay * days + 3600 * *hours + 60 * *minutes + *seconds;
}

bool isClockTime(std::string_view text) {
  return std::ranges::any_of(kDateOrders, [&](DateOrder order) { return clockSeconds(text, order).has_value(); });
}

std::vector<DateOrder> dateOrders(const std::vector<std::string>& rows) {
  std::vector<DateOrder> orders;
  for (const DateOrder order : kDateOrders)
    if (std::ranges::all_of(rows, [&](const auto& row) { return !isClockTime(row) || clockSeconds(row, order); }))
      orders.push_back(order);
  if (orders.size() < 2) return orders;
  std::optional<double> shift;
  for (const auto& row : rows) {
    if (!isClockTime(row)) continue;
    const double difference = *clockSeconds(row, orders[0]) - *clockSeconds(row, orders[1]);
    if (shift && std::abs(difference - *shift) > kDay / 2) return orders;
    shift = difference;
  }
  return {orders.front()};
}

ClockTimes clockTimes(const std::vector<std::string>& rows, DateOrder order) {
  ClockTimes times;
  double days = 0, last = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto seconds = clockSeconds(rows[k], order);
    times.seconds.push_back(seconds);
    if (!seconds || dateMark(rows[k])) continue;
    if (*seconds <= last - kDay / 2) {
      days += kDay;
      times.midnights.push_back(k);
    }
    last = *seconds;
    *times.seconds.back() += days;
  }
  return times;
}

}  // namespace tubeplan::app
