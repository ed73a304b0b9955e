// The cheapest spanning tree of a route's nodes under prices of its postures. Internal to the lower bound.
//
// A route is a tree in which each node has two edge ends (an open end of the route counts as one), both in the one
// posture that the node takes. Lagrangian prices replace the conditions that a tree may violate: u_p that a posture has
// two ends when it is taken and none else; and, on chosen pairs of nodes, w >= 0 for either end's posture that a used
// edge's posture is taken. An edge then costs straight(p, q) + u_p + u_q + w_pq,p + w_pq,q, and for any prices
//   tree + open ends - sum over nodes of max over p of (2 u_p + sum of p's w) <= travel time.
// With one posture a node it is the bound of Held and Karp (1970, 1971) for a path. If a set of postures has all of
// one node and none of another, every route crosses its border (Fischetti, Salazar and Toth 1997): a price v >= 0 is
// subtracted from each edge that does and added once to the bound.
#pragma once

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "planner/order/neighbour_lists.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

struct Prices {
  std::vector<double> of_posture;   // u
  std::vector<double> of_pair;      // w, in the order of the graph's pairs: postures of one node, then of the other
  std::vector<double> of_cut = {};  // v, in the order of the graph's cuts; missing ones are zero
};

struct PricedTree {
  double bound = 0;                        ///< valid if the tree is of the complete graph [s]
  std::vector<double> ends;                ///< number of edge ends by posture
  std::vector<double> pair_ends;           ///< number of edge ends by pair price
  std::vector<double> taken;               ///< share of each posture in its node that the prices prefer
  std::vector<double> crossings;           ///< number of edges across each cut
  std::vector<std::pair<int, int>> edges;  ///< pairs of postures
};

/// Chosen pairs of nodes, with the stored times between their postures.
class PairGraph {
 public:
  static constexpr std::size_t kMostCuts = 64;

  explicit PairGraph(const PostureTable& table)
      : table_(table), edges_of_(table.nodes()), inside_(static_cast<std::size_t>(table.postures()), 0) {}
  /// Adds a pair, unless it exists already.
  void add(int node_a, int node_b);
  /// Adds a set of postures, by posture, that has all of one node and none of another.
  void addCut(const std::vector<char>& inside);
  [[nodiscard]] std::size_t cuts() const { return cuts_; }
  [[nodiscard]] std::size_t pairPrices() const { return posture_of_price_.size(); }
  [[nodiscard]] int postureOfPrice(std::size_t price) const { return posture_of_price_[price]; }

  /// Returns the tree over the chosen pairs alone, which must connect all nodes.
  [[nodiscard]] PricedTree tree(const Prices& prices) const;
  /// Returns the tree over all pairs; times of the others are computed as needed.
  [[nodiscard]] PricedTree completeTree(const Prices& prices) const;

 private:
  struct Edge {
    int to;
    std::size_t times;                     // index for the first pair of postures, with this node's in the outer loop
    std::size_t own_prices, other_prices;  // indices for this node's first posture, and for the other's
  };
  struct Link;
  class Sum;
  /// Returns the sum that the cuts subtract from an edge.
  [[nodiscard]] double relief(const Prices& prices, int p, int q) const {
    double sum = 0;
    for (std::uint64_t across = inside_[p] ^ inside_[q]; across != 0; across &= across - 1)
      if (const auto cut = static_cast<std::size_t>(std::countr_zero(across)); cut < prices.of_cut.size())
        sum += prices.of_cut[cut];
    return sum;
  }
  void relaxPair(const Prices& prices, int node, const Edge& edge, Link& link) const;
  void relaxOther(const Prices& prices, int joined, int node, Link& link) const;

  const PostureTable& table_;
  std::vector<std::vector<Edge>> edges_of_;
  std::vector<double> times_;
  std::vector<int> posture_of_price_;
  std::vector<std::uint64_t> inside_;  ///< bits by posture, one for each cut
  std::size_t cuts_ = 0;
};

}  // namespace tubeplan::planner
