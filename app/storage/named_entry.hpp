// Entries of a table that the user selects by name.
#pragma once

#include <algorithm>
#include <concepts>
#include <ranges>
#include <string>
#include <vector>

#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"

namespace tubeplan::app {

/// Returns the name of an entry: its member `name`, or the entry itself if it is a string.
template <class Entry>
std::string nameOfEntry(const Entry& entry) {
  if constexpr (std::convertible_to<Entry, std::string>)
    return entry;
  else
    return std::string(entry.name);
}

/// Returns the names of all entries, in the order of the table.
template <std::ranges::input_range Table>
std::vector<std::string> namesOf(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.push_back(nameOfEntry(entry));
  return names;
}

/// Returns the error for a name that is not in `names`; it lists all names and suggests the most similar one.
[[nodiscard]] inline InputError unknownName(const std::string& where, const std::string& name,
                                            const std::vector<std::string>& names) {
  return InputError(where, inQuotes(name), alternatives(names), suggestion(name, names));
}

/// Returns the entry that has the name. Throws unknownName() if there is none. The table must outlive the result.
template <std::ranges::input_range Table>
const auto& entryNamed(const Table& table, const std::string& name, const std::string& where) {
  const auto found = std::ranges::find(table, name, [](const auto& entry) { return nameOfEntry(entry); });
  if (found == std::ranges::end(table)) throw unknownName(where, name, namesOf(table));
  return *found;
}

}  // namespace tubeplan::app
