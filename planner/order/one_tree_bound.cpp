#include "planner/order/one_tree_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planner/order/posture_cuts.hpp"
#include "planner/order/priced_tree.hpp"

namespace tubeplan::planner {
namespace {

// first step length, as a fraction of the difference between the known time and the bound
constexpr double kFirstStep = 1;
constexpr int kPatience = 10;  // steps without improvement before the step fraction is reduced
constexpr double kFall = 0.8;
// Weight of the latest tree in the running mean of the violations. Prices of postures can change the posture of a whole
// node, so they need a longer memory.
constexpr double kMeanShareByNodes = 0.3, kMeanShareByPostures = 0.03;
constexpr std::size_t kCutsOfRound = 10;
constexpr int kMostPosturesToCut = 1000;
// Smallest worthwhile improvement, as a fraction of the bound. Cutting ends if the possible improvement is smaller; a
// round of cuts that gains less is idle.
constexpr double kWorthwhile = 2e-3;
// Number of successive idle rounds after which cutting ends. More than one, because several cuts may be needed for an
// effect.
constexpr int kIdleCutRounds = 3;

enum class Detail { kNodes, kPostures };

// Returns how much a tree violates each condition, in the order of the prices. With Detail::kNodes, the edge ends of
// all postures of a node are counted together. With one posture per node, this covers every condition; with several, it
// is best for the first steps.
std::vector<double> violations(const PostureTable& table, const PairGraph& graph, const PricedTree& tree,
                               Detail detail) {
  const std::size_t first_cut = tree.ends.size() + tree.pair_ends.size();
  std::vector<double> violation(first_cut + tree.crossings.size(), 0.0);
  for (int node = 0; node < table.nodes(); ++node) {
    const double ends =
        std::accumulate(tree.ends.begin() + table.first(node), tree.ends.begin() + table.last(node), 0.0);
    for (int p = table.first(node); p < table.last(node); ++p) {
      violation[p] = detail == Detail::kNodes ? ends - 2 : tree.ends[p] - 2 * tree.taken[p];
    }
  }
  if (detail == Detail::kNodes) return violation;
  for (std::size_t k = 0; k < tree.pair_ends.size(); ++k) {
    violation[tree.ends.size() + k] = tree.pair_ends[k] - tree.taken[graph.postureOfPrice(k)];
  }
  for (std::size_t c = 0; c < tree.crossings.size(); ++c) violation[first_cut + c] = 1 - tree.crossings[c];
  return violation;
}

class Ascent {
 public:
  Ascent(const PostureTable& table, const OneTreeOptions& options) : table_(table), options_(options), graph_(table) {
    const bool complete = table.visits() <= options.complete_up_to;
    neighbours_ = nearestNeighbours(table, complete ? table.nodes() : options.neighbours);
    for (int node = 0; node < table.nodes(); ++node) {
      for (const Neighbour& neighbour : neighbours_[node]) graph_.add(node, neighbour.node);
    }
    best_.of_posture.assign(table.postures(), 0.0);
    best_.of_pair.assign(graph_.pairPrices(), 0.0);
  }

  // Proves the bound at the best prices so far, and adds edges of the complete tree to the sparse graph.
  void prove() {
    const PricedTree tree = graph_.completeTree(best_);
    proved_ = std::max(proved_, tree.bound);
    for (const auto& [p, q] : tree.edges) graph_.add(table_.nodeOf(p), table_.nodeOf(q));
    best_.of_pair.resize(graph_.pairPrices(), 0.0);
  }

  // Adds cuts that the trees of the last climb cross too seldom. Returns false if there are none.
  bool cut() {
    const std::size_t most = std::min(kCutsOfRound, PairGraph::kMostCuts - graph_.cuts());
    const auto cuts = findCrossedTooSeldom(table_, neighbours_, meanUse(), most);
    for (const auto& inside : cuts) graph_.addCut(inside);
    best_.of_cut.resize(graph_.cuts(), 0.0);
    return !cuts.empty();
  }

  // Improves the best prices along a running mean of the trees' violations (volume method: Barahona and Anbil 2000).
  void climb(int steps, double first_share, Detail detail) {
    const double mean_share = detail == Detail::kNodes ? kMeanShareByNodes : kMeanShareByPostures;
    double share = first_share;
    int without_gain = 0;
    PricedTree tree = graph_.tree(best_);
    double best_on_graph = tree.bound;
    use_.clear();
    use_scale_ = 1;
    std::vector<double> mean = violations(table_, graph_, tree, detail);
    for (int i = 0; i < steps && !(best_on_graph >= options_.known_time * (1 - 1e-9)); ++i, ++iterations_) {
      if (options_.stop && options_.stop()) return;
      Prices prices = moved(mean, share, best_on_graph);
      tree = graph_.tree(prices);
      if (countsUse()) addUse(tree, mean_share);
      const std::vector<double> latest = violations(table_, graph_, tree, detail);
      for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += mean_share * (latest[k] - mean[k]);
      if (tree.bound > best_on_graph) {
        if (tree.bound > best_on_graph + 1e-5 * std::abs(best_on_graph)) without_gain = 0;
        best_on_graph = tree.bound;
        best_ = std::move(prices);
        share = std::min(2.0, share * 1.1);
      } else if (++without_gain >= kPatience) {
        without_gain = 0;
        share *= kFall;
      }
    }
  }

  // Returns true if the mean use of edges is recorded in order to find cuts.
  bool countsUse() const {
    return table_.postures() > table_.nodes() && table_.visits() <= options_.cuts_up_to &&
           table_.postures() <= kMostPosturesToCut && graph_.cuts() < PairGraph::kMostCuts;
  }
  double proved() const { return proved_; }
  int iterations() const { return iterations_; }

 private:
  Prices moved(const std::vector<double>& mean, double share, double best) const {
    double norm = 1e-12;
    for (std::size_t k = 0; k < mean.size(); ++k) norm += counts(k, mean[k]) ? mean[k] * mean[k] : 0;
    const double aim = std::isfinite(options_.known_time) ? options_.known_time : 1.05 * std::max(best, proved_);
    const double length = share * std::max(aim - best, 1e-6 * std::abs(aim)) / norm;
    Prices prices = best_;
    const std::size_t postures = prices.of_posture.size();
    for (std::size_t p = 0; p < postures; ++p) prices.of_posture[p] += length * mean[p];
    const std::size_t first_cut = postures + prices.of_pair.size();
    for (std::size_t k = postures; k < first_cut; ++k)
      prices.of_pair[k - postures] = std::max(0.0, prices.of_pair[k - postures] + length * mean[k]);
    for (std::size_t k = first_cut; k < mean.size(); ++k)
      prices.of_cut[k - first_cut] = std::max(0.0, prices.of_cut[k - first_cut] + length * mean[k]);
    return prices;
  }

  // Returns false if price k belongs to a pair or a cut, is zero, and could only decrease.
  bool counts(std::size_t k, double mean) const {
    const std::size_t postures = best_.of_posture.size(), first_cut = postures + best_.of_pair.size();
    return k < postures || mean > 0 || (k < first_cut ? best_.of_pair[k - postures] : best_.of_cut[k - first_cut]) > 0;
  }

  void addUse(const PricedTree& tree, double mean_share) {
    use_scale_ *= 1 - mean_share;
    for (const auto& [p, q] : tree.edges) use_[std::minmax(p, q)] += mean_share / use_scale_;
  }

  EdgeUse meanUse() const {
    EdgeUse mean = use_;
    for (auto& [ends, share] : mean) share *= use_scale_;
    return mean;
  }

  const PostureTable& table_;
  const OneTreeOptions& options_;
  std::vector<std::vector<Neighbour>> neighbours_;
  PairGraph graph_;
  Prices best_;
  // Weighted use of edges by the trees of the current climb, divided by `use_scale_`; the latest trees have the largest
  // weights.
  EdgeUse use_;
  double use_scale_ = 1;
  double proved_ = 0;  // zero is a valid bound, because times are never negative
  int iterations_ = 0;
};

}  // namespace

OneTreeBound oneTreeBound(const Route& route, const OneTreeOptions& options) {
  OneTreeBound result;
  const std::vector<std::string> problems = findRouteProblems(route);
  if (!problems.empty()) {
    result.status = OneTreeStatus::kBadInput;
    result.reason = problems.front();
    return result;
  }
  result.status = OneTreeStatus::kSolved;
  if (route.visits.empty()) {
    result.lower_bound = route.start && route.end ? straightMoveDuration(*route.start, *route.end, route.speeds) : 0;
    return result;
  }
  const PostureTable table(route);
  Ascent ascent(table, options);
  // A tree on the complete graph takes 0.25 s for 4,674 visits, so none is started once a stop is requested.
  const auto is_stopped = [&] { return options.stop && options.stop(); };
  if (!is_stopped()) ascent.prove();
  const int rounds = std::max(1, options.rounds);
  const bool several = table.postures() > table.nodes();
  for (int round = 0; round < rounds; ++round) {
    const Detail detail = several && (round > 0 || rounds == 1) ? Detail::kPostures : Detail::kNodes;
    ascent.climb(options.iterations / rounds, kFirstStep / (1 + round), detail);
    if (is_stopped()) break;
    ascent.prove();
  }
  for (int round = 0, idle = 0; round < options.cut_rounds && idle < kIdleCutRounds; ++round) {
    const double before = ascent.proved();
    if (is_stopped() || !ascent.countsUse() || options.known_time - before < kWorthwhile * before || !ascent.cut())
      break;
    ascent.climb(options.iterations / rounds, kFirstStep, Detail::kPostures);
    ascent.prove();
    idle = ascent.proved() - before < kWorthwhile * before ? idle + 1 : 0;
  }
  result.lower_bound = ascent.proved();
  result.iterations = ascent.iterations();
  return result;
}

}  // namespace tubeplan::planner
