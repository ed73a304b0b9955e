// Readings in the words of a check.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::calibration {

/// "a, b, c" of at most five ids, and how many more.
[[nodiscard]] inline std::string listOf(const std::vector<std::string>& ids) {
  constexpr std::size_t kMostListed = 5;
  std::string text;
  for (std::size_t k = 0; k < ids.size() && k < kMostListed; ++k) text += (k ? ", " : "") + ids[k];
  return ids.size() > kMostListed ? text + " and " + std::to_string(ids.size() - kMostListed) + " more" : text;
}

/// What --assume takes to leave these out; empty where they are too many for one line.
[[nodiscard]] inline std::string assumeWithout(const std::vector<std::string>& ids) {
  constexpr std::size_t kMostAssumed = 20;
  if (ids.size() > kMostAssumed) return "";
  std::string text;
  for (const auto& id : ids) text += (text.empty() ? "without=" : ",without=") + id;
  return text;
}

}  // namespace tubeplan::calibration
