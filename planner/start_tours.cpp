#include "planner/start_tours.hpp"

#include <limits>

namespace tubeplan::planner {
namespace {

// A growing route. Its last place is a node, and one posture of it unless any will do (-1).
class NearestNeighbourTour {
 public:
  NearestNeighbourTour(const PostureTable& table, const std::vector<std::vector<Neighbour>>& neighbours)
      : table_(table), neighbours_(neighbours), seen_(table.nodes(), 0), ahead_(table.visits()) {
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
    const int from = posture_ < 0 ? table_.first(node_) : posture_, to = posture_ < 0 ? table_.last(node_) : posture_ + 1;
    for (int p = from; p < to; ++p) {
      for (int q = table_.first(node); q < table_.last(node); ++q) {
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
  std::vector<char> seen_;
  std::vector<int> ahead_, order_;
  int node_ = -1, posture_ = -1;
  double best_time_ = 0;
  int best_node_ = -1, best_posture_ = -1;
};

}  // namespace

std::vector<std::vector<int>> startTours(const PostureTable& table, const std::vector<std::vector<Neighbour>>& neighbours) {
  const auto begin = [&](int visit, int posture) {
    NearestNeighbourTour tour(table, neighbours);
    tour.append(visit, posture);
    return tour;
  };
  std::vector<std::vector<int>> tours;
  if (table.startNode() >= 0) {
    NearestNeighbourTour tour(table, neighbours);
    tour.append(table.startNode(), -1);
    tours.push_back(tour.finish());
  } else {
    tours.push_back(begin(0, -1).finish());
  }
  if (table.postures() == table.nodes()) return tours;
  const int first = tours.front().front();
  for (int p = table.first(first); p < table.last(first); ++p) tours.push_back(begin(first, p).finish());
  return tours;
}

}  // namespace tubeplan::planner
