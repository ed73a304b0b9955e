// The cheapest spanning tree of a route's nodes under prices of its postures. Internal to the lower bound.
//
// A route is a tree in which each node has two edge ends (an open end of the route counts as one), both in the one
// posture that the node takes. Lagrangian prices stand for what a tree may break: u_p that a posture has two ends when
// it is taken and none else; and, on chosen pairs of nodes, w >= 0 for either end's posture that a used edge's posture
// is taken. An edge then costs straight(p, q) + u_p + u_q + w_pq,p + w_pq,q, and for any prices
//   tree + open ends - sum over nodes of max over p of (2 u_p + sum of p's w) <= travel time.
// With one posture a node it is the bound of Held and Karp (1970, 1971) for a path.
#pragma once

#include <utility>
#include <vector>

#include "planner/order/neighbour_lists.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

struct Prices {
  std::vector<double> of_posture;  // u
  std::vector<double> of_pair;     // w, in the order of the graph's pairs: postures of the one node, then of the other
};

struct PricedTree {
  double bound = 0;                        ///< s; valid when the tree is of the complete graph
  std::vector<double> ends;                ///< edge ends by posture
  std::vector<double> pair_ends;           ///< the same by pair price
  std::vector<double> taken;               ///< share of each posture in its node, as the prices would have it
  std::vector<std::pair<int, int>> edges;  ///< nodes
};

/// Chosen pairs of nodes, with the times between their postures at hand.
class PairGraph {
 public:
  explicit PairGraph(const PostureTable& table) : table_(table), edges_of_(table.nodes()) {}
  /// Does nothing when the pair is there already.
  void add(int node_a, int node_b);
  [[nodiscard]] std::size_t pairPrices() const { return posture_of_price_.size(); }
  [[nodiscard]] int postureOfPrice(std::size_t price) const { return posture_of_price_[price]; }

  /// Over the chosen pairs alone, which must connect all nodes.
  [[nodiscard]] PricedTree tree(const Prices& prices) const;
  /// Over all pairs; times of the others are computed as they are needed.
  [[nodiscard]] PricedTree completeTree(const Prices& prices) const;

 private:
  struct Edge {
    int to;
    std::size_t times;                     // of the first pair of postures, this node's in the outer loop
    std::size_t own_prices, other_prices;  // of this node's first posture, and of the other's
  };
  struct Link;
  class Sum;
  void relaxPair(const Prices& prices, int node, const Edge& edge, Link& link) const;
  void relaxOther(const Prices& prices, int joined, int node, Link& link) const;

  const PostureTable& table_;
  std::vector<std::vector<Edge>> edges_of_;
  std::vector<double> times_;
  std::vector<int> posture_of_price_;
};

}  // namespace tubeplan::planner
