// Shifts of a job: the shift that contains a time, and the start and end of each shift.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "app/outage/job_file.hpp"

namespace tubeplan::app {

/// One shift of one day, or a part of a day outside all shifts.
struct ShiftOfDay {
  std::string date;  ///< day on which it began, in UTC, "2025-04-02"
  std::string name;  ///< name of the shift; empty outside the shifts of the job

  [[nodiscard]] auto operator<=>(const ShiftOfDay&) const = default;
};

/// Returns a shift, named after its times, for every part of the day that no shift has; none for a job without shifts.
[[nodiscard]] std::vector<JobShift> gapsBetween(const std::vector<JobShift>& shifts);

/// Returns a sentence on two shifts that have a minute in common; empty if there are none.
[[nodiscard]] std::string overlapText(const std::vector<JobShift>& shifts);

/// Returns the shift in which a time falls ("2025-04-02T06:15:30Z").
[[nodiscard]] ShiftOfDay shiftAt(const std::string& at, const std::vector<JobShift>& shifts);

/// Return the time at which a shift begins and the one at which the next begins, or the midnights around the day where
/// no shift of the job is named.
[[nodiscard]] std::string startOf(const ShiftOfDay& shift, const std::vector<JobShift>& shifts);
[[nodiscard]] std::string endOf(const ShiftOfDay& shift, const std::vector<JobShift>& shifts);

/// Returns true for a date of the calendar, of the form "2025-04-02".
[[nodiscard]] bool isDate(const std::string& date);

/// Throws InputError, naming --date, for a text that is not a date of the form "2025-04-02".
void requireDate(const std::string& date);

}  // namespace tubeplan::app
