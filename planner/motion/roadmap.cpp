#include "planner/motion/roadmap.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <queue>
#include <random>

#include "planner/motion/unit_random.hpp"

namespace tubeplan::planner {

namespace {

using Eigen::VectorXd;

constexpr int kMostDrawsPerPosture = 50;
constexpr int kEnoughAttachments = 6;
constexpr int kBridgeAttempts = 3;  // number of searches between two parts of the roadmap

VectorXd randomPosture(const MotionProblem& problem, std::mt19937_64& generator) {
  VectorXd q(problem.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    // A joint without limits is sampled over one full turn.
    const double low = std::isfinite(problem.lower[j]) ? problem.lower[j] : -std::numbers::pi;
    const double high = std::isfinite(problem.upper[j]) ? problem.upper[j] : std::numbers::pi;
    q[j] = randomBetween(low, high, generator);
  }
  return q;
}

bool isFree(const VectorXd& q, const MotionProblem& problem) { return problem.clearance_of(q).margin >= 0; }

}  // namespace

Roadmap::Roadmap(const MotionProblem& problem, std::vector<VectorXd> postures, const RoadmapOptions& options)
    : problem_(problem), options_(options) {
  assert(problem.cost);
  for (auto& q : postures)
    if (isFree(q, problem_)) postures_.push_back(std::move(q));
  addRandomPostures();
  join();
}

int Roadmap::edges() const {
  std::size_t count = 0;
  for (const auto& edges : edges_) count += edges.size();
  return static_cast<int>(count / 2);
}

void Roadmap::addRandomPostures() {
  std::mt19937_64 generator(options_.seed);
  int wanted = options_.random_postures;
  for (long draw = 0; wanted > 0 && draw < static_cast<long>(kMostDrawsPerPosture) * options_.random_postures; ++draw) {
    VectorXd q = randomPosture(problem_, generator);
    if (!isFree(q, problem_)) continue;
    postures_.push_back(std::move(q));
    --wanted;
  }
}

/// Returns the pairs of each posture and its nearest neighbours, every pair once.
std::vector<Roadmap::Candidate> Roadmap::candidates() const {
  const auto count = static_cast<std::size_t>(postures());
  std::vector<std::vector<Candidate>> nearest(count);
  oneapi::tbb::parallel_for(std::size_t{0}, count, [&](std::size_t a) {
    std::vector<Candidate> all;
    for (std::size_t b = 0; b < count; ++b)
      if (a != b)
        all.push_back({static_cast<int>(std::min(a, b)), static_cast<int>(std::max(a, b)),
                       problem_.cost(postures_[std::min(a, b)], postures_[std::max(a, b)])});
    const auto wanted = std::min(all.size(), static_cast<std::size_t>(options_.neighbours));
    std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(wanted), all.end(),
                      [](const Candidate& x, const Candidate& y) {
                        return std::tie(x.cost, x.from, x.to) < std::tie(y.cost, y.from, y.to);
                      });
    all.resize(wanted);
    nearest[a] = std::move(all);
  });
  std::vector<Candidate> pairs;
  for (const auto& list : nearest) pairs.insert(pairs.end(), list.begin(), list.end());
  const auto place = [](const Candidate& pair) { return std::pair(pair.from, pair.to); };
  std::ranges::sort(pairs, {}, place);
  const auto repeated = std::ranges::unique(pairs, {}, place);
  pairs.erase(repeated.begin(), repeated.end());
  return pairs;
}

void Roadmap::join() {
  const std::vector<Candidate> pairs = candidates();
  std::vector<char> free(pairs.size(), 0);
  oneapi::tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t k) {
    const auto& a = postures_[static_cast<std::size_t>(pairs[k].from)];
    const auto& b = postures_[static_cast<std::size_t>(pairs[k].to)];
    free[k] =
        checkMotion(a, b, problem_.clearance_of, problem_.travel, options_.check).status == MotionCheckStatus::kFree;
  });
  edges_.assign(postures_.size(), {});
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!free[k]) continue;
    edges_[static_cast<std::size_t>(pairs[k].from)].push_back({pairs[k].to, pairs[k].cost});
    edges_[static_cast<std::size_t>(pairs[k].to)].push_back({pairs[k].from, pairs[k].cost});
  }
}

std::vector<Roadmap::Edge> Roadmap::attach(const VectorXd& q, long& checks) const {
  std::vector<Edge> near;
  for (int node = 0; node < postures(); ++node)
    near.push_back({node, problem_.cost(q, postures_[static_cast<std::size_t>(node)])});
  const auto tried = std::min(near.size(), static_cast<std::size_t>(options_.attachments));
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(tried), near.end(),
                    [](const Edge& a, const Edge& b) { return std::tie(a.cost, a.to) < std::tie(b.cost, b.to); });
  std::vector<Edge> joined;
  for (std::size_t k = 0; k < tried && joined.size() < kEnoughAttachments; ++k) {
    const auto check = checkMotion(q, postures_[static_cast<std::size_t>(near[k].to)], problem_.clearance_of,
                                   problem_.travel, options_.check);
    checks += check.checks;
    if (check.status == MotionCheckStatus::kFree) joined.push_back(near[k]);
  }
  return joined;
}

/// Returns the nodes on the cheapest path (Dijkstra) that begins with an edge of `from` and ends with an edge of `to`;
/// empty if there is none.
std::vector<int> Roadmap::quickest(const std::vector<Edge>& from, const std::vector<Edge>& to) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> cost(postures_.size(), kInfinity), last(postures_.size(), kInfinity);
  std::vector<int> before(postures_.size(), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](int node, double now, int by) {
    if (!(now < cost[static_cast<std::size_t>(node)])) return;
    cost[static_cast<std::size_t>(node)] = now;
    before[static_cast<std::size_t>(node)] = by;
    open.push({now, node});
  };
  for (const Edge& edge : from) reach(edge.to, edge.cost, -1);
  for (const Edge& edge : to) last[static_cast<std::size_t>(edge.to)] = edge.cost;
  double best = kInfinity;
  int end = -1;
  while (!open.empty() && open.top().first < best) {
    const auto [now, node] = open.top();
    open.pop();
    if (now > cost[static_cast<std::size_t>(node)]) continue;
    if (now + last[static_cast<std::size_t>(node)] < best) {
      best = now + last[static_cast<std::size_t>(node)];
      end = node;
    }
    for (const Edge& edge : edges_[static_cast<std::size_t>(node)]) reach(edge.to, now + edge.cost, node);
  }
  std::vector<int> nodes;
  for (int node = end; node >= 0; node = before[static_cast<std::size_t>(node)]) nodes.push_back(node);
  std::ranges::reverse(nodes);
  return nodes;
}

std::vector<std::vector<Roadmap::Edge>> Roadmap::attachAll(const std::vector<VectorXd>& postures) const {
  std::vector<std::vector<Edge>> joined(postures.size());
  oneapi::tbb::parallel_for(std::size_t{0}, postures.size(), [&](std::size_t k) {
    long checks = 0;
    joined[k] = attach(postures[k], checks);
  });
  return joined;
}

std::vector<int> Roadmap::rootsWith(const std::vector<std::vector<Edge>>& joined) const {
  std::vector<int> root(postures_.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int node) {
    while (root[static_cast<std::size_t>(node)] != node) node = root[static_cast<std::size_t>(node)];
    return node;
  };
  const auto unite = [&](int a, int b) {
    a = find(a);
    b = find(b);
    root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  };
  for (std::size_t node = 0; node < edges_.size(); ++node)
    for (const Edge& edge : edges_[node]) unite(static_cast<int>(node), edge.to);
  for (const auto& list : joined)
    for (const Edge& edge : list) unite(list.front().to, edge.to);
  for (int node = 0; node < postures(); ++node) root[static_cast<std::size_t>(node)] = find(node);
  return root;
}

std::vector<int> Roadmap::partsOf(const std::vector<VectorXd>& postures) const {
  const auto joined = attachAll(postures);
  const std::vector<int> root = rootsWith(joined);
  std::map<int, int> numbers;
  std::vector<int> parts;
  for (const auto& list : joined)
    parts.push_back(
        list.empty()
            ? -1
            : numbers.emplace(root[static_cast<std::size_t>(list.front().to)], static_cast<int>(numbers.size()))
                  .first->second);
  return parts;
}

/// Searches for a path of straight moves between two parts, from some of their pairs of nearest nodes, the nearest pair
/// first. Returns its waypoints; empty if none is found.
std::vector<VectorXd> Roadmap::wayBetween(const std::vector<int>& from, const std::vector<int>& to,
                                          MotionPlannerOptions options) const {
  std::vector<Candidate> nearest;
  for (const int a : from) {
    Candidate best{a, -1, std::numeric_limits<double>::infinity()};
    for (const int b : to)
      if (const double cost =
              problem_.cost(postures_[static_cast<std::size_t>(a)], postures_[static_cast<std::size_t>(b)]);
          cost < best.cost)
        best = {a, b, cost};
    nearest.push_back(best);
  }
  std::ranges::sort(nearest, [](const Candidate& x, const Candidate& y) {
    return std::tie(x.cost, x.from, x.to) < std::tie(y.cost, y.from, y.to);
  });
  MotionProblem straight = problem_;
  straight.speeds.reset();
  for (int attempt = 0; attempt < kBridgeAttempts; ++attempt) {
    const auto& pair = nearest[nearest.size() * static_cast<std::size_t>(attempt) / kBridgeAttempts];
    options.seed += 1;
    const MotionPlan plan = planMotion(postures_[static_cast<std::size_t>(pair.from)],
                                       postures_[static_cast<std::size_t>(pair.to)], straight, options);
    if (plan.status == MotionPlanStatus::kFree) return plan.waypoints;
  }
  return {};
}

void Roadmap::addWay(const std::vector<VectorXd>& way) {
  const auto join = [&](int a, int b) {
    const double cost = problem_.cost(postures_[static_cast<std::size_t>(a)], postures_[static_cast<std::size_t>(b)]);
    edges_[static_cast<std::size_t>(a)].push_back({b, cost});
    edges_[static_cast<std::size_t>(b)].push_back({a, cost});
  };
  const auto nodeOf = [&](const VectorXd& q) {
    const auto at = std::ranges::find(postures_, q);
    if (at != postures_.end()) return static_cast<int>(at - postures_.begin());
    postures_.push_back(q);
    edges_.emplace_back();
    return postures() - 1;
  };
  int before = nodeOf(way.front());
  for (std::size_t k = 1; k < way.size(); ++k) {
    const int node = nodeOf(way[k]);
    join(before, node);
    before = node;
  }
}

bool Roadmap::bridge(const std::vector<VectorXd>& postures, const MotionPlannerOptions& options) {
  const auto joined = attachAll(postures);
  const std::vector<int> root = rootsWith(joined);
  std::map<int, int> attached_count;  // number of postures attached to each part
  for (const auto& list : joined)
    if (!list.empty()) ++attached_count[root[static_cast<std::size_t>(list.front().to)]];
  if (attached_count.size() < 2) return false;
  std::map<int, std::vector<int>> nodes;
  for (int node = 0; node < static_cast<int>(root.size()); ++node)
    nodes[root[static_cast<std::size_t>(node)]].push_back(node);
  const int main =
      std::ranges::max_element(attached_count, [](const auto& a, const auto& b) { return a.second < b.second; })->first;
  attached_count.erase(main);
  // Searches are serialised, because OMPL's planners share data about their spaces.
  bool found = false;
  for (const auto& [part, count] : attached_count) {
    const auto way = wayBetween(nodes.at(part), nodes.at(main), options);
    if (way.empty()) continue;
    addWay(way);
    found = true;
  }
  return found;
}

RoadmapWay Roadmap::between(const VectorXd& q0, const VectorXd& q1, long& checks) const {
  const std::vector<Edge> from = attach(q0, checks);
  if (from.empty()) return {RoadmapStatus::kUnattached, {}};
  const std::vector<Edge> to = attach(q1, checks);
  if (to.empty()) return {RoadmapStatus::kUnattached, {}};
  const std::vector<int> nodes = quickest(from, to);
  if (nodes.empty()) return {RoadmapStatus::kDisconnected, {}};
  RoadmapWay way{RoadmapStatus::kFound, {q0}};
  for (const int node : nodes) way.waypoints.push_back(postures_[static_cast<std::size_t>(node)]);
  way.waypoints.push_back(q1);
  return way;
}

}  // namespace tubeplan::planner
