// Log entries made by a person: name, reason and time.
#pragma once

#include <string>

namespace tubeplan::app {

/// Entry for an item; an empty `at` means the current time.
struct EventEntry {
  std::string person, reason, at;
};

/// Returns the present time in UTC, "2025-04-02T06:15:30Z".
[[nodiscard]] std::string presentTime();

/// Returns the entry with blanks around its texts removed. Throws InputError, naming the option, for a name without a
/// letter or digit, for a text of several lines, for a time that the calendar does not have, and for one that is more
/// than ten minutes later than now.
[[nodiscard]] EventEntry checkedEntry(const EventEntry& entry);

/// Returns true if two names denote the same person: equal letters and digits, ignoring case.
[[nodiscard]] bool isSamePerson(const std::string& first, const std::string& second);

}  // namespace tubeplan::app
