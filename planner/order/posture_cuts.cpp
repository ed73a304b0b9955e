#include "planner/order/posture_cuts.hpp"

#include <algorithm>
#include <limits>

namespace tubeplan::planner {

namespace {

constexpr double kLeastUse = 1e-3;   // smallest mean use of an edge that the search considers
constexpr double kEnough = 0.95;     // a flow of at least this much is treated as a full crossing
constexpr double kLeastFlow = 1e-6;  // smallest residual capacity of an edge that a path may use
constexpr int kSources = 4;          // number of visits that are used as sources of flows

/// Flow network of the used edges; all postures of a visit together form one source or sink.
class UsedEdges {
 public:
  UsedEdges(const PostureTable& table, const EdgeUse& use) : table_(table), full_(table.postures()) {
    for (const auto& [ends, share] : use) {
      if (share < kLeastUse) continue;
      const auto [p, q] = ends;
      const int at_p = static_cast<int>(full_[p].size()), at_q = static_cast<int>(full_[q].size());
      full_[p].push_back({q, at_q, share});
      full_[q].push_back({p, at_p, share});
    }
  }

  [[nodiscard]] bool isUsed(int posture) const { return !full_[posture].empty(); }

  /// Returns the maximum flow between two visits, or some flow of at least kEnough. If the flow is less than kEnough,
  /// `reached` has the postures on the source side of the minimum cut.
  double flow(int from, int to, std::vector<char>& reached) {
    residual_graph_ = full_;
    double sum = 0;
    while (sum < kEnough) {
      const int end = search(from, to, reached);
      if (end < 0) break;
      sum += augment(end);
    }
    return sum;
  }

 private:
  struct Edge {
    int to, back;
    double residual;
  };

  /// Returns a posture of the visit `to` that is reached by a path with residual capacity; -1 if there is none.
  int search(int from, int to, std::vector<char>& reached) {
    reached.assign(full_.size(), 0);
    came_from_.assign(full_.size(), {-1, -1});
    std::vector<int> queue;
    for (int p = table_.first(from); p < table_.last(from); ++p) reached[p] = 1, queue.push_back(p);
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (std::size_t e = 0; e < residual_graph_[queue[k]].size(); ++e) {
        const Edge& edge = residual_graph_[queue[k]][e];
        if (reached[edge.to] || edge.residual < kLeastFlow) continue;
        reached[edge.to] = 1;
        came_from_[edge.to] = {queue[k], static_cast<int>(e)};
        if (table_.nodeOf(edge.to) == to) return edge.to;
        queue.push_back(edge.to);
      }
    return -1;
  }

  double augment(int end) {
    double most = std::numeric_limits<double>::infinity();
    for (int p = end; came_from_[p].first >= 0; p = came_from_[p].first)
      most = std::min(most, residual_graph_[came_from_[p].first][came_from_[p].second].residual);
    for (int p = end; came_from_[p].first >= 0; p = came_from_[p].first) {
      Edge& edge = residual_graph_[came_from_[p].first][came_from_[p].second];
      edge.residual -= most;
      residual_graph_[p][edge.back].residual += most;
    }
    return most;
  }

  const PostureTable& table_;
  std::vector<std::vector<Edge>> full_, residual_graph_;
  /// Previous posture on the path and index of the edge from it; -1 if there is none.
  std::vector<std::pair<int, int>> came_from_;
};

}  // namespace

std::vector<std::vector<char>> findCrossedTooSeldom(const PostureTable& table,
                                                    const std::vector<std::vector<Neighbour>>& neighbours,
                                                    const EdgeUse& use, std::size_t most) {
  UsedEdges edges(table, use);
  const auto sideOf = [&](int posture, const std::vector<char>& reached) {
    double nearest = std::numeric_limits<double>::infinity();
    char side = 0;
    for (const Neighbour& neighbour : neighbours[table.nodeOf(posture)])
      for (int q = table.first(neighbour.node); q < table.last(neighbour.node); ++q)
        if (edges.isUsed(q) && table.straight(posture, q) < nearest)
          nearest = table.straight(posture, q), side = reached[q];
    return side;
  };
  std::vector<std::vector<char>> cuts;
  std::vector<char> reached;
  for (int k = 0; k < kSources; ++k) {
    const int from = k * table.visits() / kSources;
    for (int to = 0; to < table.visits() && cuts.size() < most; ++to) {
      const auto parts = [&](const std::vector<char>& cut) {
        const int of_from = table.sideOf(from, cut), of_to = table.sideOf(to, cut);
        return of_from >= 0 && of_to >= 0 && of_from != of_to;
      };
      if (to == from || std::ranges::any_of(cuts, parts) || edges.flow(from, to, reached) >= kEnough) continue;
      std::vector<char> cut = reached;
      for (int p = 0; p < table.postures(); ++p)
        if (!edges.isUsed(p) && table.nodeOf(p) != from && table.nodeOf(p) != to) cut[p] = sideOf(p, reached);
      cuts.push_back(std::move(cut));
    }
  }
  return cuts;
}

}  // namespace tubeplan::planner
