#include "planner/order/neighbour_lists.hpp"

#include <algorithm>
#include <limits>

namespace tubeplan::planner {
namespace {

bool nearer(const Neighbour& a, const Neighbour& b) { return a.time != b.time ? a.time < b.time : a.node < b.node; }

int widestJoint(const PostureTable& table) {
  int widest = 0;
  double greatest = -1;
  for (int j = 0; j < table.joints(); ++j) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int p = 0; p < table.postures(); ++p) {
      low = std::min(low, table.scaled(p, j));
      high = std::max(high, table.scaled(p, j));
    }
    if (high - low > greatest) {
      greatest = high - low;
      widest = j;
    }
  }
  return widest;
}

// The `count` nearest nodes offered so far, nearest first, each listed once.
class BestNodes {
 public:
  explicit BestNodes(std::size_t count) : count_(count) {}
  double worst() const { return list_.size() < count_ ? std::numeric_limits<double>::infinity() : list_.back().time; }
  void offer(const Neighbour& candidate) {
    const auto same =
        std::find_if(list_.begin(), list_.end(), [&](const Neighbour& n) { return n.node == candidate.node; });
    if (same != list_.end()) {
      if (!nearer(candidate, *same)) return;
      list_.erase(same);
    }
    list_.insert(std::upper_bound(list_.begin(), list_.end(), candidate, nearer), candidate);
    if (list_.size() > count_) list_.pop_back();
  }
  std::vector<Neighbour> take() { return std::move(list_); }

 private:
  std::size_t count_;
  std::vector<Neighbour> list_;
};

// Postures sorted by the value of one joint. The time that this joint needs at full speed is a lower bound on the time
// of a move, so a scan along the postures can stop early.
struct Sweep {
  explicit Sweep(const PostureTable& table)
      : joint(widestJoint(table)), sorted(table.postures()), place(table.postures()) {
    for (int p = 0; p < table.postures(); ++p) sorted[p] = p;
    std::sort(sorted.begin(), sorted.end(), [&](int a, int b) {
      return table.scaled(a, joint) != table.scaled(b, joint) ? table.scaled(a, joint) < table.scaled(b, joint) : a < b;
    });
    for (int i = 0; i < table.postures(); ++i) place[sorted[i]] = i;
  }
  int joint;
  std::vector<int> sorted, place;
};

void scan(const PostureTable& table, const Sweep& sweep, int posture, int step, BestNodes& best) {
  const int node = table.nodeOf(posture), size = table.postures();
  for (int i = sweep.place[posture] + step; i >= 0 && i < size; i += step) {
    const int other = sweep.sorted[i];
    const double at_least = std::abs(table.scaled(other, sweep.joint) - table.scaled(posture, sweep.joint));
    if (at_least > best.worst()) return;
    if (table.nodeOf(other) == node) continue;
    const Neighbour candidate{table.nodeOf(other), table.straight(posture, other)};
    if (candidate.time <= best.worst()) best.offer(candidate);
  }
}

}  // namespace

std::vector<std::vector<Neighbour>> nearestNeighbours(const PostureTable& table, int count) {
  const Sweep sweep(table);
  std::vector<std::vector<Neighbour>> lists;
  lists.reserve(table.nodes());
  for (int node = 0; node < table.nodes(); ++node) {
    BestNodes best(static_cast<std::size_t>(std::max(1, count)));
    for (int p = table.first(node); p < table.last(node); ++p) {
      scan(table, sweep, p, +1, best);
      scan(table, sweep, p, -1, best);
    }
    lists.push_back(best.take());
  }
  return lists;
}

}  // namespace tubeplan::planner
