#include "app/files/foreign/clock_time.hpp"

#include <chrono>
#include <string>

#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

constexpr double kDay = 86400;  // s

bool hasDate(std::string_view text) { return text.find_first_of("-/") != std::string_view::npos; }

/// Digits up to this mark, which is taken off with them.
std::optional<int> takeNumber(std::string_view& text, std::string_view marks) {
  const std::size_t end = text.find_first_of(marks);
  if (end == std::string_view::npos || end == 0 || end > 4) return std::nullopt;
  const auto number = tubesheets::parseInteger(text.substr(0, end));
  text.remove_prefix(end + 1);
  return number && *number >= 0 ? number : std::nullopt;
}

/// Days since 1970, of a date in front that is taken off.
std::optional<double> takeDays(std::string_view& text) {
  const auto year = takeNumber(text, "-/"), month = takeNumber(text, "-/"), day = takeNumber(text, " T");
  if (!year || !month || !day) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok()) return std::nullopt;
  return static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

}  // namespace

std::optional<double> clockSeconds(std::string_view text) {
  double days = 0;
  if (hasDate(text)) {
    const auto found = takeDays(text);
    if (!found) return std::nullopt;
    days = *found;
  }
  const auto hours = takeNumber(text, ":"), minutes = takeNumber(text, ":");
  const auto seconds = tubesheets::parseNumber(text);
  if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 || !(*seconds >= 0 && *seconds < 61))
    return std::nullopt;
  return kDay * days + 3600 * *hours + 60 * *minutes + *seconds;
}

ClockTimes clockTimes(const std::vector<std::string>& rows) {
  ClockTimes times;
  double days = 0, last = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto seconds = clockSeconds(rows[k]);
    times.seconds.push_back(seconds);
    if (!seconds || hasDate(rows[k])) continue;
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
