#include "planner/positions/base_cover.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>

namespace tubeplan::planner {

namespace {

/// A set of candidates, and the number of tubes that exactly these candidates reach.
struct TubeGroup {
  std::vector<int> by;  ///< candidates, ascending
  int tubes = 0;
};

std::vector<TubeGroup> groupsOf(const std::vector<std::vector<bool>>& reaches) {
  std::map<std::vector<int>, int> counts;
  for (std::size_t t = 0; t < reaches.front().size(); ++t) {
    std::vector<int> by;
    for (std::size_t c = 0; c < reaches.size(); ++c)
      if (reaches[c][t]) by.push_back(static_cast<int>(c));
    if (!by.empty()) ++counts[by];
  }
  std::vector<TubeGroup> groups;
  for (const auto& [by, count] : counts) groups.push_back({by, count});
  return groups;
}

/// Search over choices of candidates.
class CoverSearch {
 public:
  CoverSearch(std::size_t candidates, const std::vector<TubeGroup>& groups, const BaseCoverOptions& options)
      : groups_(groups), options_(options), of_candidate_(candidates), times_(groups.size(), 0) {
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const int c : groups[g].by) of_candidate_[static_cast<std::size_t>(c)].push_back(g);
  }

  void findBest(BaseCover& cover) {
    nodes_ = 0;
    extend(0, 0, 0, cover);
    if (nodes_ >= options_.most_nodes) {
      cover.status = BaseCoverStatus::kNotProved;
      cover.at_most = std::min(cover.reachable, sumOfLargest(gains(0), options_.most));
    } else {
      cover.at_most = cover.reached;
    }
  }

  void findAll(BaseCover& cover) {
    nodes_ = 0;
    cover.all = greedy();
    std::vector<int> chosen;
    coverRest(chosen, cover);
    std::ranges::sort(cover.all);
    cover.at_least = static_cast<int>(cover.all.size());
    if (nodes_ < options_.most_nodes) return;
    cover.status = BaseCoverStatus::kNotProved;
    cover.at_least = independentGroups();
  }

 private:
  /// Returns the number of further tubes that each candidate from `first` on reaches.
  [[nodiscard]] std::vector<int> gains(std::size_t first) const {
    std::vector<int> gain(of_candidate_.size(), 0);
    for (std::size_t c = first; c < of_candidate_.size(); ++c)
      for (const std::size_t g : of_candidate_[c])
        if (times_[g] == 0) gain[c] += groups_[g].tubes;
    return gain;
  }

  static int sumOfLargest(std::vector<int> values, int count) {
    count = std::min(count, static_cast<int>(values.size()));
    std::partial_sort(values.begin(), values.begin() + count, values.end(), std::greater());
    return std::accumulate(values.begin(), values.begin() + count, 0);
  }

  void take(std::size_t candidate, int by) {
    for (const std::size_t g : of_candidate_[candidate]) times_[g] += by;
  }

  /// Extends the choice by candidates from `first` on, in ascending order.
  void extend(std::size_t first, int taken, int reached, BaseCover& cover) {
    if (reached > cover.reached) {
      cover.reached = reached;
      cover.best = chosen_;
    }
    if (taken == options_.most || ++nodes_ >= options_.most_nodes) return;
    const std::vector<int> gain = gains(first);
    for (std::size_t c = first; c < of_candidate_.size(); ++c) {
      const std::vector<int> remaining_gain(gain.begin() + static_cast<std::ptrdiff_t>(c), gain.end());
      if (reached + sumOfLargest(remaining_gain, options_.most - taken) <= cover.reached) return;
      if (gain[c] == 0) continue;
      take(c, 1);
      chosen_.push_back(static_cast<int>(c));
      extend(c + 1, taken + 1, reached + gain[c], cover);
      chosen_.pop_back();
      take(c, -1);
    }
  }

  /// Returns candidates that together reach all tubes, chosen greedily: each one adds the most tubes.
  std::vector<int> greedy() {
    std::vector<int> found;
    while (true) {
      const std::vector<int> gain = gains(0);
      const auto most = std::ranges::max_element(gain);
      if (*most == 0) break;
      found.push_back(static_cast<int>(most - gain.begin()));
      take(static_cast<std::size_t>(found.back()), 1);
    }
    for (const int c : found) take(static_cast<std::size_t>(c), -1);
    return found;
  }

  /// Returns the open group with the fewest candidates; the number of groups if none is open.
  [[nodiscard]] std::size_t hardest() const {
    std::size_t found = groups_.size();
    for (std::size_t g = 0; g < groups_.size(); ++g)
      if (times_[g] == 0 && (found == groups_.size() || groups_[g].by.size() < groups_[found].by.size())) found = g;
    return found;
  }

  /// Returns the size of a set of open groups such that no candidate reaches two of them. At least that many candidates
  /// are needed.
  [[nodiscard]] int independentGroups() const {
    std::vector<bool> is_used(of_candidate_.size(), false);
    int count = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const auto isUsed = [&](int c) { return is_used[static_cast<std::size_t>(c)]; };
      if (times_[g] > 0 || std::ranges::any_of(groups_[g].by, isUsed)) continue;
      for (const int c : groups_[g].by) is_used[static_cast<std::size_t>(c)] = true;
      ++count;
    }
    return count;
  }

  void coverRest(std::vector<int>& chosen, BaseCover& cover) {
    if (++nodes_ >= options_.most_nodes) return;
    const std::size_t group = hardest();
    if (group == groups_.size()) {
      if (chosen.size() < cover.all.size()) cover.all = chosen;
      return;
    }
    if (chosen.size() + static_cast<std::size_t>(independentGroups()) >= cover.all.size()) return;
    for (const int c : groups_[group].by) {
      take(static_cast<std::size_t>(c), 1);
      chosen.push_back(c);
      coverRest(chosen, cover);
      chosen.pop_back();
      take(static_cast<std::size_t>(c), -1);
    }
  }

  const std::vector<TubeGroup>& groups_;
  const BaseCoverOptions& options_;
  std::vector<std::vector<std::size_t>> of_candidate_;  // groups that each candidate reaches
  std::vector<int> times_;                              // number of chosen candidates that reach each group
  std::vector<int> chosen_;
  long nodes_ = 0;
};

}  // namespace

BaseCover coverByBases(const std::vector<std::vector<bool>>& reaches, const BaseCoverOptions& options) {
  assert(options.most > 0);
  BaseCover cover;
  cover.status = BaseCoverStatus::kNothingReached;
  if (reaches.empty()) return cover;
  const std::vector<TubeGroup> groups = groupsOf(reaches);
  for (const TubeGroup& group : groups) cover.reachable += group.tubes;
  if (groups.empty()) return cover;
  cover.status = BaseCoverStatus::kProved;
  CoverSearch search(reaches.size(), groups, options);
  search.findBest(cover);
  search.findAll(cover);
  return cover;
}

}  // namespace tubeplan::planner
