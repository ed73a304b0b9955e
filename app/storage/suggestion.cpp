#include "app/storage/suggestion.hpp"

#include <algorithm>

#include "app/storage/lower_case.hpp"

namespace tubeplan::app {

namespace {

// Returns the number of changed, missing, added and swapped letters between two words (optimal string alignment
// distance), ignoring case.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const bool same = lowerCase(a[i - 1]) == lowerCase(b[j - 1]);
      cost[i][j] = std::min({cost[i - 1][j - 1] + (same ? 0 : 1), cost[i - 1][j] + 1, cost[i][j - 1] + 1});
      const bool swapped =
          i > 1 && j > 1 && lowerCase(a[i - 1]) == lowerCase(b[j - 2]) && lowerCase(a[i - 2]) == lowerCase(b[j - 1]);
      if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  return cost[a.size()][b.size()];
}

/// Returns the words separated by commas, the last two by `last`.
std::string joined(const std::vector<std::string>& words, std::string_view last) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text.append(k == 0 ? "" : k + 1 == words.size() ? last : ", ").append(words[k]);
  return text;
}

}  // namespace

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongestWord = 64;
  if (word.size() > kLongestWord) return "";
  const auto distance = [&](const std::string& candidate) { return editDistance(word, candidate); };
  const auto nearest = std::min_element(candidates.begin(), candidates.end(),
                                        [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (nearest == candidates.end()) return "";
  const std::size_t allowed = std::max<std::size_t>(1, std::min(word.size(), nearest->size()) / 3);
  return distance(*nearest) <= allowed ? "did you mean '" + *nearest + "'?" : "";
}

std::string suggestionOr(std::string_view word, const std::vector<std::string>& candidates,
                         const std::string& otherwise) {
  const std::string near = suggestion(word, candidates);
  return near.empty() ? otherwise : near;
}

std::string alternatives(const std::vector<std::string>& words) { return joined(words, " or "); }

std::string enumeration(const std::vector<std::string>& words) { return joined(words, " and "); }

}  // namespace tubeplan::app
