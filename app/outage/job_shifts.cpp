#include "app/outage/job_shifts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

std::chrono::year_month_day dayOf(const std::string& date) {
  int year = 0;
  unsigned month = 0, day = 0;
  (void)std::sscanf(date.c_str(), "%4d-%2u-%2u", &year, &month, &day);
  return {std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
}

/// Returns the date that lies `days` after a date.
std::string shifted(const std::string& date, int days) {
  const std::chrono::year_month_day day{std::chrono::sys_days(dayOf(date)) + std::chrono::days(days)};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                     static_cast<unsigned>(day.day()));
}

/// Returns the time that lies `minutes` after the midnight with which a date begins.
std::string timeAt(const std::string& date, int minutes) {
  return fmt::format("{}T{:02}:{:02}:00Z", shifted(date, minutes / kMinutesPerDay), minutes % kMinutesPerDay / 60,
                     minutes % 60);
}

}  // namespace

ShiftOfDay shiftAt(const std::string& at, const std::vector<JobShift>& shifts) {
  const int minute = 60 * std::stoi(at.substr(11, 2)) + std::stoi(at.substr(14, 2));
  const std::string date = at.substr(0, 10);
  for (const JobShift& shift : shifts) {
    const int since = (minute - shift.from + kMinutesPerDay) % kMinutesPerDay;
    if (since < lengthOf(shift)) return {minute >= shift.from ? date : shifted(date, -1), shift.name};
  }
  return {date, ""};
}

std::string startOf(const ShiftOfDay& shift, const std::vector<JobShift>& shifts) {
  const auto found = std::ranges::find(shifts, shift.name, &JobShift::name);
  return timeAt(shift.date, found == shifts.end() ? 0 : found->from);
}

std::string endOf(const ShiftOfDay& shift, const std::vector<JobShift>& shifts) {
  const auto found = std::ranges::find(shifts, shift.name, &JobShift::name);
  return timeAt(shift.date, found == shifts.end() ? kMinutesPerDay : found->from + lengthOf(*found));
}

void requireDate(const std::string& date) {
  if (date.size() != 10 || !dayOf(date).ok() || shifted(date, 0) != date)
    throw InputError("--date", inQuotes(date), "a day in UTC, such as 2027-04-02");
}

}  // namespace tubeplan::app
