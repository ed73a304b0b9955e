#include "planner/order/start_tours.hpp"

#include <algorithm>
#include <limits>

namespace tubeplan::planner {
namespace {

constexpr int kNarrowView = 3, kWideView = 60;  // rounds of averaging, for a narrow and a wide neighbourhood

// For each node, returns the posture with the shortest time to neighbouring nodes, averaged over nearby postures. Each
// round widens the region of the average.
std::vector<int> locallyQuickest(const PostureTable& table, const std::vector<std::vector<Neighbour>>& neighbours,
                                 int rounds) {
  std::vector<std::vector<int>> nearby(table.postures());
  std::vector<double> time(table.postures(), 0.0), averaged(time);
  for (int p = 0; p < table.postures(); ++p) {
    for (const Neighbour& neighbour : neighbours[table.nodeOf(p)]) {
      const int q = table.nearestPosture(p, neighbour.node);
      nearby[p].push_back(q);
      time[p] += table.straight(p, q) / static_cast<double>(neighbours[table.nodeOf(p)].size());
    }
  }
  for (int round = 0; round < rounds; ++round) {
    for (int p = 0; p < table.postures(); ++p) {
      averaged[p] = time[p];
      for (const int q : nearby[p]) averaged[p] += time[q];
      averaged[p] /= static_cast<double>(1 + nearby[p].size());
    }
    time.swap(averaged);
  }
  std::vector<int> quickest(table.nodes());
  for (int node = 0; node < table.nodes(); ++node) {
    quickest[node] = static_cast<int>(
        std::min_element(time.begin() + table.first(node), time.begin() + table.last(node)) - time.begin());
  }
  return quickest;
}

// A route that grows node by node. Its posture at the last node is either fixed or still undecided (-1).
class NearestNeighbourTour {
 public:
  // `only`: index of the one posture allowed at each node; empty if all are allowed.
  NearestNeighbourTour(const PostureTable& table, const std::vector<std::vector<Neighbour>>& neighbours,
                       std::vector<int> only = {})
      : table_(table),
        neighbours_(neighbours),
        only_(std::move(only)),
        seen_(table.nodes(), 0),
        ahead_(table.visits()) {
    for (int v = 0; v < table.visits(); ++v) ahead_[v] = v;
  }

  void append(int node, int posture) {
    node_ = node;
    posture_ = posture;
    seen_[node] = 1;
    if (node < table_.visits()) order_.push_back(node);
  }

  void appendNearest() {
    best_time_ = std::numeric_limits<double>::infinity();
    for (const Neighbour& neighbour : neighbours_[node_]) {
      if (neighbour.time >= best_time_) break;
      offer(neighbour.node);
    }
    if (best_time_ == std::numeric_limits<double>::infinity()) offerAll();
    append(best_node_, posture_ < 0 ? -1 : best_posture_);
  }

  std::vector<int> finish() {
    while (static_cast<int>(order_.size()) < table_.visits()) appendNearest();
    return order_;
  }

 private:
  void offer(int node) {
    if (node >= table_.visits() || seen_[node]) return;
    const int from = posture_ < 0 ? table_.first(node_) : posture_,
              to = posture_ < 0 ? table_.last(node_) : posture_ + 1;
    for (int p = from; p < to; ++p) {
      for (int q = table_.first(node); q < table_.last(node); ++q) {
        if (!only_.empty() && only_[node] != q) continue;
        const double time = table_.cost(p, q);
        if (time >= best_time_) continue;
        best_time_ = time;
        best_node_ = node;
        best_posture_ = q;
      }
    }
  }

  void offerAll() {
    std::erase_if(ahead_, [&](int visit) { return seen_[visit] != 0; });
    for (const int visit : ahead_) offer(visit);
  }

  const PostureTable& table_;
  const std::vector<std::vector<Neighbour>>& neighbours_;
  std::vector<int> only_;
  std::vector<char> seen_;
  std::vector<int> ahead_, order_;
  int node_ = -1, posture_ = -1;
  double best_time_ = 0;
  int best_node_ = -1, best_posture_ = -1;
};

}  // namespace

std::vector<std::vector<int>> startTours(const PostureTable& table,
                                         const std::vector<std::vector<Neighbour>>& neighbours) {
  const auto grow = [&](int node, int posture, std::vector<int> only) {
    NearestNeighbourTour tour(table, neighbours, std::move(only));
    tour.append(node, posture);
    return tour.finish();
  };
  const int begin = table.startNode() >= 0 ? table.startNode() : 0;
  std::vector<std::vector<int>> tours{grow(begin, -1, {})};
  if (table.postures() == table.nodes()) return tours;
  const int first = tours.front().front();
  for (int p = table.first(first); p < table.last(first); ++p) tours.push_back(grow(first, p, {}));
  for (const int rounds : {kNarrowView, kWideView}) {
    const std::vector<int> only = locallyQuickest(table, neighbours, rounds);
    tours.push_back(grow(begin, only[begin], only));
  }
  return tours;
}

}  // namespace tubeplan::planner
