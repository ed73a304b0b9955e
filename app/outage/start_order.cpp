#include "app/outage/start_order.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace tubeplan::app {

namespace {

constexpr std::size_t kMostOrdered = 12;  // largest number of legs for which the search is exhaustive

/// Partial schedule: the legs already placed, and the times at which arms and groups become available.
struct Begun {
  std::uint64_t legs = 0;      ///< set of the legs that have begun
  double last = 0;             ///< latest beginning [s]; none of the other legs begins earlier
  std::vector<double> arms;    ///< time at which each arm becomes available [s]
  std::vector<double> groups;  ///< time at which each group of exclusive legs becomes available [s]
};

class StartOrderSearch {
 public:
  StartOrderSearch(const std::vector<LegWork>& legs, int arms, const std::vector<ExclusiveLegs>& exclusive_legs,
                   double lower_bound)
      : legs_(legs), exclusive_legs_(exclusive_legs), groups_of_(legs.size()), lower_bound_(lower_bound) {
    for (std::size_t group = 0; group < exclusive_legs.size(); ++group)
      for (const int leg : exclusive_legs[group]) groups_of_[static_cast<std::size_t>(leg)].push_back(group);
    begun_.arms.assign(std::min(static_cast<std::size_t>(arms), legs.size()), 0);
    begun_.groups.assign(exclusive_legs.size(), 0);
  }

  StartOrder solve() {
    takeByPriority([&](std::size_t leg) { return legs_[leg].duration; });
    takeByPriority([&](std::size_t leg) { return longestGroup(leg); });
    const bool is_exact = legs_.size() <= kMostOrdered;
    if (is_exact) branch();
    best_.is_optimal = is_exact || best_.end <= lower_bound_;
    return best_;
  }

 private:
  [[nodiscard]] bool hasBegun(std::size_t leg) const { return (begun_.legs >> leg & 1) != 0; }

  /// Returns the earliest time at which a leg can begin after those that have begun [s].
  [[nodiscard]] double earliest(std::size_t leg) const {
    double at = std::max(begun_.last, *std::ranges::min_element(begun_.arms));
    for (const std::size_t group : groups_of_[leg]) at = std::max(at, begun_.groups[group]);
    return at;
  }

  /// Returns the work of the largest group of a leg, or of the leg alone [s].
  [[nodiscard]] double longestGroup(std::size_t leg) const {
    double longest = legs_[leg].duration;
    for (const std::size_t group : groups_of_[leg]) {
      double sum = 0;
      for (const int other : exclusive_legs_[group]) sum += legs_[static_cast<std::size_t>(other)].duration;
      longest = std::max(longest, sum);
    }
    return longest;
  }

  /// Starts a leg as early as possible, on the arm with the shortest idle time.
  void begin(std::size_t leg) {
    const double start = earliest(leg), end = start + legs_[leg].duration;
    std::size_t arm = begun_.arms.size();
    for (std::size_t k = 0; k < begun_.arms.size(); ++k)
      if (begun_.arms[k] <= start && (arm == begun_.arms.size() || begun_.arms[k] > begun_.arms[arm])) arm = k;
    order_.push_back(
        {static_cast<int>(leg), static_cast<int>(arm), start, end, WaitReason::kNone, -1, start - begun_.arms[arm]});
    begun_.legs |= std::uint64_t{1} << leg;
    begun_.last = start;
    begun_.arms[arm] = end;
    for (const std::size_t group : groups_of_[leg]) begun_.groups[group] = end;
  }

  /// Begins whichever leg can begin first; of several, the one with the highest priority.
  template <class Priority>
  void takeByPriority(const Priority& priority) {
    const Begun none = begun_;
    while (order_.size() < legs_.size()) {
      std::size_t next = legs_.size();
      for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
        if (hasBegun(leg)) continue;
        const bool is_better = next == legs_.size() || earliest(leg) < earliest(next) ||
                               (earliest(leg) == earliest(next) && priority(leg) > priority(next));
        if (is_better) next = leg;
      }
      begin(next);
    }
    keepIfBest();
    begun_ = none;
    order_.clear();
  }

  void keepIfBest() {
    const double end = std::ranges::max(order_, {}, &ScheduledLeg::end).end;
    if (best_.legs.empty() || end < best_.end) best_ = {order_, end, false};
  }

  /// Returns a lower bound of the time at which all remaining legs have ended [s].
  [[nodiscard]] double bound() const {
    double work = 0, least = 0;
    std::vector<double> of_group(exclusive_legs_.size(), 0), group_from(exclusive_legs_.size(), 1e300);
    for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
      if (hasBegun(leg)) continue;
      const double from = earliest(leg);
      work += legs_[leg].duration;
      least = std::max(least, from + legs_[leg].duration);
      for (const std::size_t group : groups_of_[leg]) {
        of_group[group] += legs_[leg].duration;
        group_from[group] = std::min(group_from[group], from);
      }
    }
    for (std::size_t group = 0; group < exclusive_legs_.size(); ++group)
      if (of_group[group] > 0) least = std::max(least, group_from[group] + of_group[group]);
    for (const double free : begun_.arms) work += std::max(free, begun_.last);
    return std::max(least, work / static_cast<double>(begun_.arms.size()));
  }

  /// Returns true if a stored partial schedule with the same legs dominates this one; otherwise stores this one.
  bool isDominated() {
    std::vector<double> free = begun_.arms;
    std::ranges::sort(free);
    free.insert(free.end(), begun_.groups.begin(), begun_.groups.end());
    for (double& at : free) at = std::max(at, begun_.last);
    free.push_back(begun_.last);
    auto& known = known_[begun_.legs];
    const auto isAtLeastAsEarly = [&](const std::vector<double>& other) {
      return std::equal(other.begin(), other.end(), free.begin(), std::less_equal<>());
    };
    if (std::ranges::any_of(known, isAtLeastAsEarly)) return true;
    known.push_back(std::move(free));
    return false;
  }

  void branch() {
    if (best_.end <= lower_bound_) return;
    if (order_.size() == legs_.size()) return keepIfBest();
    if (bound() >= best_.end || isDominated()) return;
    const Begun before = begun_;
    for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
      if (hasBegun(leg)) continue;
      begin(leg);
      branch();
      begun_ = before;
      order_.pop_back();
    }
  }

  const std::vector<LegWork>& legs_;
  const std::vector<ExclusiveLegs>& exclusive_legs_;
  std::vector<std::vector<std::size_t>> groups_of_;  ///< indices of the groups of each leg
  double lower_bound_ = 0;
  Begun begun_;
  std::vector<ScheduledLeg> order_;
  StartOrder best_;
  std::unordered_map<std::uint64_t, std::vector<std::vector<double>>> known_;
};

}  // namespace

StartOrder bestStartOrder(const std::vector<LegWork>& legs, int arms, const std::vector<ExclusiveLegs>& exclusive_legs,
                          double lower_bound) {
  return StartOrderSearch(legs, arms, exclusive_legs, lower_bound).solve();
}

}  // namespace tubeplan::app
