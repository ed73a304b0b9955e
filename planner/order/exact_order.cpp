#include "planner/order/exact_order.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace tubeplan::planner {

namespace {

constexpr int kMostVisits = 20;  // largest number of visits; a set of visits is stored as one bit for each visit

using VisitSet = std::uint32_t;

Eigen::MatrixXd timesBy(const PostureTable& table, double (PostureTable::*time)(int, int) const) {
  Eigen::MatrixXd times = Eigen::MatrixXd::Zero(table.postures(), table.postures());
  for (int p = 0; p < table.postures(); ++p)
    for (int q = 0; q < p; ++q) times(p, q) = times(q, p) = (table.*time)(p, q);
  return times;
}

/// For each visit, returns the visits that must precede it. `zones` has the zone of each visit, or is empty if there
/// are no zones.
std::vector<VisitSet> visitsBefore(int visits, const std::vector<int>& zones) {
  std::vector<VisitSet> before(static_cast<std::size_t>(visits), 0);
  if (zones.empty()) return before;
  for (std::size_t v = 0; v < before.size(); ++v)
    for (std::size_t w = 0; w < before.size(); ++w)
      if (zones[w] < zones[v]) before[v] |= VisitSet{1} << w;
  return before;
}

/// Returns the order for a route without visits: from the start posture to the end posture, if both are given.
ExactOrder betweenEnds(const PostureTable& table, const Eigen::MatrixXd& times) {
  ExactOrder order{{}, table.postures() == 2 ? times(0, 1) : 0};
  for (int p = 0; p < table.postures(); ++p) order.postures.push_back(p);
  return order;
}

/// Dynamic programming: fills a table over sets of visits and last postures, from which the quickest order is read.
class Programme {
 public:
  Programme(const PostureTable& table, const Eigen::MatrixXd& times, const std::vector<int>& zones)
      : table_(table),
        times_(times),
        before_(visitsBefore(table.visits(), zones)),
        standing_(table.last(table.visits() - 1)),
        all_((VisitSet{1} << table.visits()) - 1),
        least_(Eigen::ArrayXXd::Constant(standing_, Eigen::Index{all_} + 1, kNever)),
        came_from_(Eigen::ArrayXXi::Constant(standing_, Eigen::Index{all_} + 1, -1)) {}

  ExactOrder solve() {
    begin();
    for (VisitSet set = 1; set < all_; ++set)
      for (int v = 0; v < table_.visits(); ++v)
        if (set >> v & 1)
          for (int p = table_.first(v); p < table_.last(v); ++p)
            if (least_(p, set) < kNever) extend(set, p);
    return best();
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool mayCome(int visit, VisitSet set) const {
    return !(set >> visit & 1) && (before_[static_cast<std::size_t>(visit)] & ~set) == 0;
  }

  void begin() {
    const int start = table_.startNode();
    for (int v = 0; v < table_.visits(); ++v) {
      if (!mayCome(v, 0)) continue;
      for (int p = table_.first(v); p < table_.last(v); ++p)
        least_(p, VisitSet{1} << v) = start < 0 ? 0 : times_(table_.first(start), p);
    }
  }

  /// Extends a set whose last posture is p to every posture of every visit that may come next.
  void extend(VisitSet set, int p) {
    const double time_before = least_(p, set);
    for (int v = 0; v < table_.visits(); ++v) {
      if (!mayCome(v, set)) continue;
      const VisitSet next = set | VisitSet{1} << v;
      for (int q = table_.first(v); q < table_.last(v); ++q) {
        const double time = time_before + times_(q, p);
        if (!(time < least_(q, next))) continue;
        least_(q, next) = time;
        came_from_(q, next) = p;
      }
    }
  }

  [[nodiscard]] ExactOrder best() const {
    const int start = table_.startNode(), end = table_.endNode();
    ExactOrder order;
    Eigen::ArrayXd total_times = least_.col(all_);
    if (end >= 0) total_times += times_.col(table_.first(end)).head(standing_).array();
    Eigen::Index last = 0;
    order.time = total_times.minCoeff(&last);
    if (end >= 0) order.postures.push_back(table_.first(end));
    VisitSet set = all_;
    for (int p = static_cast<int>(last); p >= 0;) {
      order.postures.push_back(p);
      const int before = came_from_(p, set);
      set &= ~(VisitSet{1} << table_.nodeOf(p));
      p = before;
    }
    if (start >= 0) order.postures.push_back(table_.first(start));
    std::ranges::reverse(order.postures);
    return order;
  }

  const PostureTable& table_;
  const Eigen::MatrixXd& times_;
  std::vector<VisitSet> before_;
  int standing_;  // number of postures of all visits
  VisitSet all_;
  Eigen::ArrayXXd least_;      // shortest time by last posture and set of visits [s]
  Eigen::ArrayXXi came_from_;  // previous posture, by last posture and set of visits; -1 if there is none
};

}  // namespace

bool isForExactOrder(const PostureTable& table, double most_work) {
  const double postures = table.postures();
  return table.visits() <= kMostVisits && std::ldexp(postures * postures, table.visits()) <= most_work;
}

Eigen::MatrixXd straightTimes(const PostureTable& table) { return timesBy(table, &PostureTable::straight); }

Eigen::MatrixXd timesWithExtra(const PostureTable& table) { return timesBy(table, &PostureTable::cost); }

ExactOrder exactOrder(const PostureTable& table, const Eigen::MatrixXd& times, const std::vector<int>& zones) {
  assert(table.visits() <= kMostVisits);
  assert(zones.empty() || static_cast<int>(zones.size()) == table.visits());
  if (table.visits() == 0) return betweenEnds(table, times);
  return Programme(table, times, zones).solve();
}

}  // namespace tubeplan::planner
