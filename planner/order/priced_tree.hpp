// The cheapest spanning tree of a route's nodes under prices of its postures. Internal to the lower bound.
//
// A route is a tree in which each node has two edge ends (an open end of the route is also an edge end), both at the
// posture that the node takes. Lagrangian prices replace the conditions that a tree may violate. Price u_p is for the
// condition that posture p has two edge ends if it is taken, and none otherwise. Price w >= 0, for chosen pairs of
// nodes, is for the condition that both postures of a used edge are taken. An edge then costs straight(p, q) + u_p +
// u_q + w_pq,p + w_pq,q, and for any prices
//   tree + open ends - sum over nodes of max over p of (2 u_p + sum of p's w) <= travel time.
// With one posture per node this is the bound of Held and Karp (1970, 1971) for a path. If a set of postures has all
// postures of one node and none of another, every route crosses the set's border (Fischetti, Salazar and Toth 1997): a
// price v >= 0 is subtracted from each edge across the border and added once to the bound.
#pragma once

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "planner/order/neighbour_lists.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

struct Prices {
  std::vector<double> of_posture;  // price u of each posture, for the condition on its edge ends
  // prices w: one for each posture of both nodes of each chosen pair. The pairs are in the order of the graph; within a
  // pair, the postures of one node come first, then the postures of the other.
  std::vector<double> of_pair;
  std::vector<double> of_cut = {};  // price v of each cut, in the order of the graph's cuts; missing prices are zero
};

struct PricedTree {
  double bound = 0;          ///< lower bound of the travel time, valid if the tree was found on the complete graph [s]
  std::vector<double> ends;  ///< number of edge ends at each posture
  std::vector<double> pair_ends;  ///< number of edge ends that each pair price applies to
  /// Fraction to which each posture is taken at its node; sums to 1 over the postures of a node.
  std::vector<double> taken;
  std::vector<double> crossings;           ///< number of edges across each cut
  std::vector<std::pair<int, int>> edges;  ///< edges of the tree as pairs of postures
};

/// A sparse graph of nodes, which stores the times between all postures of each connected pair of nodes.
class PairGraph {
 public:
  static constexpr std::size_t kMostCuts = 64;

  explicit PairGraph(const PostureTable& table)
      : table_(table), edges_of_(table.nodes()), inside_(static_cast<std::size_t>(table.postures()), 0) {}
  /// Adds a pair of nodes, unless the graph has it already.
  void add(int node_a, int node_b);
  /// Adds a cut: a set of postures, given by one flag per posture, that has all postures of one node and none of
  /// another.
  void addCut(const std::vector<char>& inside);
  [[nodiscard]] std::size_t cuts() const { return cuts_; }
  [[nodiscard]] std::size_t pairPrices() const { return posture_of_price_.size(); }
  [[nodiscard]] int postureOfPrice(std::size_t price) const { return posture_of_price_[price]; }

  /// Returns the cheapest tree over the chosen pairs alone, which must connect all nodes.
  [[nodiscard]] PricedTree tree(const Prices& prices) const;
  /// Returns the cheapest tree over all pairs of nodes; times of pairs that are not stored are computed as needed.
  [[nodiscard]] PricedTree completeTree(const Prices& prices) const;

 private:
  struct Edge {
    int to;
    // Index in `times_` of the first pair of postures; the index of the other node's posture varies fastest.
    std::size_t times;
    // price indices of this node's first posture and of the other node's first posture
    std::size_t own_prices, other_prices;
    std::size_t least_times;  // index in `least_times_` of this node's first posture
  };
  struct Link;
  class Sum;
  /// Returns the sum of the prices of all cuts that separate p from q, to be subtracted from the cost of the edge.
  [[nodiscard]] double relief(const Prices& prices, int p, int q) const {
    double sum = 0;
    for (std::uint64_t across = inside_[p] ^ inside_[q]; across != 0; across &= across - 1)
      if (const auto cut = static_cast<std::size_t>(std::countr_zero(across)); cut < prices.of_cut.size())
        sum += prices.of_cut[cut];
    return sum;
  }
  /// `most_relief`: upper bound of relief().
  void relaxPair(const Prices& prices, double most_relief, int node, const Edge& edge, Link& link) const;
  void relaxOther(const Prices& prices, int joined, int node, Link& link) const;

  const PostureTable& table_;
  std::vector<std::vector<Edge>> edges_of_;
  std::vector<double> times_;
  std::vector<double> least_times_;  ///< for each edge and posture of its node, the least of the edge's times
  std::vector<int> posture_of_price_;
  std::vector<std::uint64_t> inside_;  ///< for each posture, one bit per cut: 1 if the cut contains the posture
  std::size_t cuts_ = 0;
};

}  // namespace tubeplan::planner
