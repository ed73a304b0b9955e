#include "app/outage/job_shifts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

constexpr int kMinutesPerDay = 24 * 60;

/// Returns the duration of a shift [min]; a shift with equal start and end lasts one day.
int lengthOf(const JobShift& shift) { return (shift.to - shift.from + kMinutesPerDay - 1) % kMinutesPerDay + 1; }

bool contains(const JobShift& shift, int minute) {
  return (minute - shift.from + kMinutesPerDay) % kMinutesPerDay < lengthOf(shift);
}

/// Returns the first shift that contains a minute of the day; null if there is none.
const JobShift* shiftAtMinute(int minute, const std::vector<JobShift>& shifts) {
  const auto found = std::ranges::find_if(shifts, [&](const JobShift& shift) { return contains(shift, minute); });
  return found == shifts.end() ? nullptr : &*found;
}

std::string timeOfDay(int minute) { return fmt::format("{:02}:{:02}", minute / 60, minute % 60); }

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
  return fmt::format("{}T{}:00Z", shifted(date, minutes / kMinutesPerDay), timeOfDay(minutes % kMinutesPerDay));
}

}  // namespace

std::vector<JobShift> gapsBetween(const std::vector<JobShift>& shifts) {
  std::vector<JobShift> gaps;
  const auto isGap = [&](int minute) { return !shiftAtMinute(minute % kMinutesPerDay, shifts); };
  for (int from = 0; from < kMinutesPerDay && !shifts.empty(); ++from) {
    if (!isGap(from) || isGap(from + kMinutesPerDay - 1)) continue;
    int to = from;
    while (isGap(to)) ++to;
    to %= kMinutesPerDay;
    gaps.push_back({timeOfDay(from) + "-" + timeOfDay(to), from, to});
  }
  return gaps;
}

std::string overlapText(const std::vector<JobShift>& shifts) {
  for (int minute = 0; minute < kMinutesPerDay; ++minute) {
    const JobShift* first = shiftAtMinute(minute, shifts);
    for (const JobShift& other : shifts)
      if (&other != first && contains(other, minute))
        return fmt::format("the shifts {} and {} overlap at {}", first->name, other.name, timeOfDay(minute));
  }
  return "";
}

ShiftOfDay shiftAt(const std::string& at, const std::vector<JobShift>& shifts) {
  const int minute = 60 * std::stoi(at.substr(11, 2)) + std::stoi(at.substr(14, 2));
  const std::string date = at.substr(0, 10);
  const JobShift* shift = shiftAtMinute(minute, shifts);
  if (!shift) return {date, ""};
  return {minute >= shift->from ? date : shifted(date, -1), shift->name};
}

std::string startOf(const ShiftOfDay& shift, const std::vector<JobShift>& shifts) {
  const auto found = std::ranges::find(shifts, shift.name, &JobShift::name);
  return timeAt(shift.date, found == shifts.end() ? 0 : found->from);
}

std::string endOf(const ShiftOfDay& shift, const std::vector<JobShift>& shifts) {
  const auto found = std::ranges::find(shifts, shift.name, &JobShift::name);
  return timeAt(shift.date, found == shifts.end() ? kMinutesPerDay : found->from + lengthOf(*found));
}

bool isDate(const std::string& date) { return date.size() == 10 && dayOf(date).ok() && shifted(date, 0) == date; }

void requireDate(const std::string& date) {
  if (!isDate(date)) throw InputError("--date", inQuotes(date), "a day in UTC, such as 2025-04-02");
}

}  // namespace tubeplan::app
