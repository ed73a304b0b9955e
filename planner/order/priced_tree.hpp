// The cheapest spanning tree of a route's nodes under prices of its postures. Internal to the lower bound.
//
// A route is a tree in which each node has two edge ends (an open end of the route counts as one), both in the one
// posture that the node takes. Lagrangian prices stand for what a tree may break: u_p that a posture has two ends when
// it is taken and none else; and, on chosen pairs of nodes, w >= 0 for either end's posture that a used edge's posture
// is taken. An edge then costs straight(p, q) + u_p + u_q + w_pq,p + w_pq,q, and for any prices
//   tree + open ends - sum over nodes of max over p of (2 u_p + sum of p's w) <= travel time.
// With one posture a node it is the bound of Held and Karp (1970, 1971) for a path. Where a set of postures has all of
// one node and none of another, every route crosses its border (Fischetti, Salazar and Toth 1997): a price v >= 0 is
// taken off each edge that does and added once to the bound.
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
  std::vector<double> of_pair;      // w, in the order of the graph's pairs: postures of the one node, then of the other
  std::vector<double> of_cut = {};  // v, in the order of the graph's cuts; those that are not there are zero
};

struct PricedTree {
  double bound = 0;                        ///< s; valid when the tree is of the complete graph
  std::vector<double> ends;                ///< edge ends by posture
  std::vector<double> pair_ends;           ///< the same by pair price
  std::vector<double> taken;               ///< share of each posture in its node, as the prices would have it
  std::vector<double> crossings;           ///< edges across each cut
  std::vector<std::pair<int, int>> edges;  ///< postures
};

/// Chosen pairs of nodes, with the times between their postures at hand.
class PairGraph {
 public:
  static constexpr std::size_t kMostCuts = 64;

  explicit PairGraph(const PostureTable& table)
      : table_(table), edges_of_(table.nodes()), inside_(static_cast<std::size_t>(table.postures()), 0) {}
  /// Does nothing when the pair is there already.
  void add(int node_a, int node_b);
  /// A set of postures, by posture, that has all of one node and none of another.
  void addCut(const std::vector<char>& inside);
  [[nodiscard]] std::size_t cuts() const { return cuts_; }
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
  /// What the cuts take off an edge.
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
  std::vector<std::uint64_t> inside_;  ///< by posture, a bit for each cut
  std::size_t cuts_ = 0;
};

}  // namespace tubeplan::planner
