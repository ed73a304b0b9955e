#include "planner/order/priced_tree.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>

namespace tubeplan::planner {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTieShare = 1e-9;
constexpr double kRounding = 1e-9;  // tolerance above the rounding error of a sum of prices [s]
constexpr int kFewPostures = 3;
constexpr std::size_t kNoPrice = std::numeric_limits<std::size_t>::max();

bool joinsBothEnds(const PostureTable& table, int a, int b) { return a >= table.visits() && b >= table.visits(); }

}  // namespace

// The cheapest known link from a node to the tree.
struct PairGraph::Link {
  double price = kInfinity;
  int from = -1, to = -1;  // indices of the link's postures
  std::size_t from_price = kNoPrice, to_price = kNoPrice;
};

class PairGraph::Sum {
 public:
  Sum(const PairGraph& graph, const Prices& prices) : graph_(graph), table_(graph.table_), prices_(prices) {
    tree_.ends.assign(table_.postures(), 0);
    tree_.pair_ends.assign(graph.pairPrices(), 0);
    tree_.taken.assign(table_.postures(), 0);
    tree_.crossings.assign(graph.cuts(), 0);
    tree_.edges.reserve(table_.nodes());
  }

  void addEdge(const Link& link) {
    add(link.price);
    ++tree_.ends[link.from];
    ++tree_.ends[link.to];
    if (link.from_price != kNoPrice) ++tree_.pair_ends[link.from_price];
    if (link.to_price != kNoPrice) ++tree_.pair_ends[link.to_price];
    for (std::uint64_t across = graph_.inside_[link.from] ^ graph_.inside_[link.to]; across != 0; across &= across - 1)
      ++tree_.crossings[static_cast<std::size_t>(std::countr_zero(across))];
    tree_.edges.emplace_back(link.from, link.to);
  }

  PricedTree finish() {
    addRouteEnds();
    for (const double price : prices_.of_cut) add(price);
    std::vector<double> worth(table_.postures());
    for (int p = 0; p < table_.postures(); ++p) worth[p] = 2 * prices_.of_posture[p];
    for (std::size_t k = 0; k < prices_.of_pair.size(); ++k) worth[graph_.postureOfPrice(k)] += prices_.of_pair[k];
    for (int node = 0; node < table_.nodes(); ++node) takePostures(node, worth);
    tree_.bound = sum_ - 1e-12 * magnitude_;  // subtract the rounding error, so that the bound stays valid
    return std::move(tree_);
  }

 private:
  void add(double value) {
    sum_ += value;
    magnitude_ += std::abs(value);
  }

  // Selects the posture of highest value at a node. Postures of equal value share the node in proportion to their edge
  // ends, so that prices need less correction.
  void takePostures(int node, const std::vector<double>& worth) {
    const double greatest = *std::max_element(worth.begin() + table_.first(node), worth.begin() + table_.last(node));
    add(-greatest);
    const double tie = greatest - kTieShare * (1 + std::abs(greatest));
    double ends = 0, equals = 0;
    for (int p = table_.first(node); p < table_.last(node); ++p) {
      if (worth[p] < tie) continue;
      ends += tree_.ends[p];
      ++equals;
    }
    for (int p = table_.first(node); p < table_.last(node); ++p) {
      if (worth[p] >= tie) tree_.taken[p] = ends > 0 ? tree_.ends[p] / ends : 1 / equals;
    }
  }

  int cheapestPosture(int node) const {
    const auto begin = prices_.of_posture.begin();
    return static_cast<int>(std::min_element(begin + table_.first(node), begin + table_.last(node)) - begin);
  }

  void addEnd(int node) {
    const int posture = cheapestPosture(node);
    add(prices_.of_posture[posture]);
    ++tree_.ends[posture];
  }

  // Adds the ends of the route. A given start or end posture has one more edge end; a free end is added at the cheapest
  // visit, two free ends at the two cheapest visits.
  void addRouteEnds() {
    for (int node = table_.visits(); node < table_.nodes(); ++node) addEnd(node);
    const int free_ends = 2 - (table_.nodes() - table_.visits());
    std::vector<std::pair<double, int>> cheapest;
    for (int v = 0; v < table_.visits(); ++v) cheapest.emplace_back(prices_.of_posture[cheapestPosture(v)], v);
    const int count = std::min(free_ends, table_.visits());
    std::partial_sort(cheapest.begin(), cheapest.begin() + count, cheapest.end());
    for (int k = 0; k < free_ends; ++k) addEnd(cheapest[std::min(k, count - 1)].second);
  }

  const PairGraph& graph_;
  const PostureTable& table_;
  const Prices& prices_;
  PricedTree tree_;
  double sum_ = 0, magnitude_ = 0;
};

void PairGraph::add(int node_a, int node_b) {
  if (joinsBothEnds(table_, node_a, node_b)) return;
  for (const Edge& edge : edges_of_[node_a]) {
    if (edge.to == node_b) return;
  }
  const std::size_t prices_a = posture_of_price_.size();
  for (int p = table_.first(node_a); p < table_.last(node_a); ++p) posture_of_price_.push_back(p);
  const std::size_t prices_b = posture_of_price_.size();
  for (int p = table_.first(node_b); p < table_.last(node_b); ++p) posture_of_price_.push_back(p);
  const auto addSense = [&](int from, int to, std::size_t own, std::size_t other) {
    edges_of_[from].push_back({to, times_.size(), own, other, least_times_.size()});
    for (int p = table_.first(from); p < table_.last(from); ++p) {
      double least = kInfinity;
      for (int q = table_.first(to); q < table_.last(to); ++q) {
        times_.push_back(table_.straight(p, q));
        least = std::min(least, times_.back());
      }
      least_times_.push_back(least);
    }
  };
  addSense(node_a, node_b, prices_a, prices_b);
  addSense(node_b, node_a, prices_b, prices_a);
}

void PairGraph::addCut(const std::vector<char>& inside) {
  assert(cuts_ < kMostCuts);
  bool has_whole = false, lacks_whole = false;
  for (int node = 0; node < table_.nodes(); ++node) {
    const int side = table_.sideOf(node, inside);
    has_whole |= side == 1;
    lacks_whole |= side == 0;
  }
  assert(has_whole && lacks_whole);
  for (std::size_t p = 0; p < inside_.size(); ++p)
    if (inside[p]) inside_[p] |= std::uint64_t{1} << cuts_;
  ++cuts_;
}

void PairGraph::relaxPair(const Prices& prices, double most_relief, int node, const Edge& edge, Link& link) const {
  const int p0 = table_.first(node), q0 = table_.first(edge.to), q1 = table_.last(edge.to);
  // Rows of postures that cannot give a cheaper link are skipped, if skipping saves more time than it costs.
  double least_q = q1 - q0 > kFewPostures ? kInfinity : -kInfinity;
  for (int q = q0; q1 - q0 > kFewPostures && q < q1; ++q)
    least_q = std::min(least_q, prices.of_posture[q] + prices.of_pair[edge.other_prices + (q - q0)]);
  least_q -= most_relief + kRounding;
  for (int p = p0; p < table_.last(node); ++p) {
    const std::size_t own = edge.own_prices + (p - p0);
    const double price_p = prices.of_posture[p] + prices.of_pair[own];
    if (least_times_[edge.least_times + (p - p0)] + price_p + least_q >= link.price) continue;
    const double* time = &times_[edge.times + static_cast<std::size_t>(p - p0) * static_cast<std::size_t>(q1 - q0)];
    for (int q = q0; q < q1; ++q) {
      const std::size_t other = edge.other_prices + (q - q0);
      const double price = *time++ + price_p + prices.of_posture[q] + prices.of_pair[other] - relief(prices, p, q);
      if (price < link.price) link = {price, p, q, own, other};
    }
  }
}

void PairGraph::relaxOther(const Prices& prices, int joined, int node, Link& link) const {
  for (int p = table_.first(joined); p < table_.last(joined); ++p) {
    for (int q = table_.first(node); q < table_.last(node); ++q) {
      const double posture_prices = prices.of_posture[p] + prices.of_posture[q] - relief(prices, p, q);
      if (std::abs(table_.scaled(p, 0) - table_.scaled(q, 0)) + posture_prices >= link.price) continue;
      const double price = table_.straight(p, q) + posture_prices;
      if (price < link.price) link = {price, p, q, kNoPrice, kNoPrice};
    }
  }
}

PricedTree PairGraph::tree(const Prices& prices) const {
  Sum sum(*this, prices);
  const double most_relief = std::accumulate(prices.of_cut.begin(), prices.of_cut.end(), 0.0);
  std::vector<Link> links(table_.nodes());
  std::vector<char> joined(table_.nodes(), 0);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  queue.emplace(0.0, 0);
  int count = 0;
  while (!queue.empty()) {
    const int node = queue.top().second;
    queue.pop();
    if (joined[node]) continue;
    joined[node] = 1;
    if (++count > 1) sum.addEdge(links[node]);
    for (const Edge& edge : edges_of_[node]) {
      if (joined[edge.to]) continue;
      const double before = links[edge.to].price;
      relaxPair(prices, most_relief, node, edge, links[edge.to]);
      if (links[edge.to].price < before) queue.emplace(links[edge.to].price, edge.to);
    }
  }
  assert(count == table_.nodes());
  return sum.finish();
}

PricedTree PairGraph::completeTree(const Prices& prices) const {
  Sum sum(*this, prices);
  const double most_relief = std::accumulate(prices.of_cut.begin(), prices.of_cut.end(), 0.0);
  std::vector<Link> links(table_.nodes());
  std::vector<int> outside, paired_with(table_.nodes(), -1);
  for (int node = 1; node < table_.nodes(); ++node) outside.push_back(node);
  int joined = 0;
  while (!outside.empty()) {
    for (const Edge& edge : edges_of_[joined]) {
      paired_with[edge.to] = joined;
      relaxPair(prices, most_relief, joined, edge, links[edge.to]);
    }
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < outside.size(); ++i) {
      const int node = outside[i];
      if (paired_with[node] != joined && !joinsBothEnds(table_, joined, node))
        relaxOther(prices, joined, node, links[node]);
      if (links[node].price < links[outside[nearest]].price) nearest = i;
    }
    joined = outside[nearest];
    sum.addEdge(links[joined]);
    outside[nearest] = outside.back();
    outside.pop_back();
  }
  return sum.finish();
}

}  // namespace tubeplan::planner
