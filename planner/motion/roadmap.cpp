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

VectorXd randomPosture(const MotionProblem& problem, std::mt19937_64& generator) {
  VectorXd q(problem.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    // A joint without limits goes once around.
    const double low = std::isfinite(problem.lower[j]) ? problem.lower[j] : -std::numbers::pi;
    const double high = std::isfinite(problem.upper[j]) ? problem.upper[j] : std::numbers::pi;
    q[j] = low + (high - low) * unitRandom(generator);
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

/// Each posture with its nearest ones, every pair once.
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

/// Dijkstra's shortest path from any of the first to any of the second; empty where there is none.
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

std::vector<int> Roadmap::partsOf(const std::vector<VectorXd>& postures) const {
  std::vector<std::vector<Edge>> joined(postures.size());
  oneapi::tbb::parallel_for(std::size_t{0}, postures.size(), [&](std::size_t k) {
    long checks = 0;
    joined[k] = attach(postures[k], checks);
  });
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
  std::map<int, int> numbers;
  std::vector<int> parts;
  for (const auto& list : joined)
    parts.push_back(
        list.empty() ? -1 : numbers.emplace(find(list.front().to), static_cast<int>(numbers.size())).first->second);
  return parts;
}

RoadmapWay Roadmap::between(const VectorXd& q0, const VectorXd& q1, long& checks) const {
  const std::vector<Edge> from = attach(q0, checks);
  if (from.empty()) return {RoadmapStatus::kUnattached, {}};
  const std::vector<Edge> to = attach(q1, checks);
  if (to.empty()) return {RoadmapStatus::kUnattached, {}};
  const std::vector<int> nodes = quickest(from, to);
  if (nodes.empty()) return {RoadmapStatus::kApart, {}};
  RoadmapWay way{RoadmapStatus::kFound, {q0}};
  for (const int node : nodes) way.waypoints.push_back(postures_[static_cast<std::size_t>(node)]);
  way.waypoints.push_back(q1);
  return way;
}

}  // namespace tubeplan::planner
