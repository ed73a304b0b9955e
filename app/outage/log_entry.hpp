// What a person may enter in the log: names, reasons and times.
#pragma once

#include <string>

namespace tubeplan::app {

/// What is recorded of an item; `at` is the present time if it is empty.
struct EventEntry {
  std::string who, reason, at;
};

/// Returns the entry with blanks around its texts removed. Throws InputError, naming the option, for a name without a
/// letter or digit, for a text of several lines, and for a time that the calendar does not have.
[[nodiscard]] EventEntry checkedEntry(const EventEntry& entry);

/// Returns true if two names are of one person: the same letters and digits, in upper or lower case.
[[nodiscard]] bool isSamePerson(const std::string& one, const std::string& other);

}  // namespace tubeplan::app
