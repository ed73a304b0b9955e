#include "app/outage/log_entry.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <string_view>

#include "app/outage/job_shifts.hpp"
#include "app/storage/input_error.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

/// Returns the letters and digits of a name in lower case; bytes beyond ASCII are kept as they are.
std::string lettersOf(const std::string& name) {
  std::string letters;
  for (const unsigned char c : name)
    if (std::isalnum(c) != 0 || c > 127) letters += static_cast<char>(std::tolower(c));
  return letters;
}

/// Returns the text without blanks around it. Throws InputError if it has several lines.
std::string lineOf(const std::string& text, const char* option) {
  const std::string line(tubesheets::trimBlanks(text));
  if (std::ranges::any_of(line, [](unsigned char c) { return std::iscntrl(c) != 0; }))
    throw InputError::problem(option, "the text has a tabulator, a line break or another control character",
                              "write one line of plain text");
  return line;
}

/// Returns true for a time of this century in UTC, of the form "2025-04-02T06:15:30Z".
bool isTime(const std::string& text) {
  constexpr std::string_view kPattern = "20dd-dd-ddTdd:dd:ddZ";
  bool fits = text.size() == kPattern.size();
  for (std::size_t k = 0; fits && k < text.size(); ++k)
    fits = kPattern[k] == 'd' ? std::isdigit(static_cast<unsigned char>(text[k])) != 0 : text[k] == kPattern[k];
  const auto numberAt = [&](std::size_t place) { return std::stoi(text.substr(place, 2)); };
  return fits && isDate(text.substr(0, 10)) && numberAt(11) < 24 && numberAt(14) < 60 && numberAt(17) < 60;
}

/// Longest time by which an event may be later than this computer's clock, because clocks differ.
constexpr std::chrono::minutes kClocksDiffer{10};

std::string timeText(std::chrono::system_clock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

}  // namespace

std::string presentTime() { return timeText(std::chrono::system_clock::now()); }

EventEntry checkedEntry(const EventEntry& entry) {
  if (!entry.at.empty() && !isTime(entry.at))
    throw InputError("--at", inQuotes(entry.at), "a time in UTC, such as 2025-04-02T06:15:30Z");
  if (entry.at > timeText(std::chrono::system_clock::now() + kClocksDiffer))
    throw InputError::problem("--at", fmt::format("{} has not come yet: it is {}", entry.at, presentTime()),
                              "write when it happened, in UTC, or leave it out for now");
  const EventEntry checked{lineOf(entry.person, "--by"), lineOf(entry.reason, "--reason"), entry.at};
  if (lettersOf(checked.person).empty())
    throw InputError::problem("--by", "the name of the person is missing", "write --by NAME");
  return checked;
}

bool isSamePerson(const std::string& first, const std::string& second) { return lettersOf(first) == lettersOf(second); }

}  // namespace tubeplan::app
