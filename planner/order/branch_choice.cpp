#include "planner/order/branch_choice.hpp"

#include <algorithm>
#include <cassert>

#include "deflection/resized.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {
namespace {

std::string orderProblem(const Route& route, const std::vector<int>& order) {
  std::vector<char> seen(route.visits.size(), 0);
  for (const int visit : order) {
    if (visit < 0 || visit >= static_cast<int>(seen.size()))
      return "the order names visit " + std::to_string(visit) + ", which does not exist";
    if (seen[visit]) return "the order names visit " + std::to_string(visit) + " twice";
    seen[visit] = 1;
  }
  return "";
}

// Computes the shortest time to reach each posture of `node` from the postures of the node before, and records the best
// predecessor of each posture of `node`.
void extendLayer(const PostureTable& table, int before, int node, const Eigen::ArrayXd& times_before,
                 Eigen::ArrayXd& times, std::vector<int>& came_from) {
  deflection::resizeOrEmpty(times, table.last(node) - table.first(node), 1);
  Eigen::ArrayXd costs;
  for (int p = table.first(node); p < table.last(node); ++p) {
    table.costsTo(before, p, costs);
    costs += times_before;
    Eigen::Index quickest = 0;
    times[p - table.first(node)] = costs.minCoeff(&quickest);
    came_from[p] = table.first(before) + static_cast<int>(quickest);
  }
}

}  // namespace

double choosePostures(const PostureTable& table, const std::vector<int>& node_order,
                      std::vector<int>& posture_of_node) {
  if (node_order.empty()) return 0;
  std::vector<int> came_from(table.postures(), -1);
  Eigen::ArrayXd times = Eigen::ArrayXd::Zero(table.last(node_order[0]) - table.first(node_order[0])), next;
  for (std::size_t k = 1; k < node_order.size(); ++k) {
    extendLayer(table, node_order[k - 1], node_order[k], times, next, came_from);
    times.swap(next);
  }
  Eigen::Index quickest = 0;
  const double least = times.minCoeff(&quickest);
  int posture = table.first(node_order.back()) + static_cast<int>(quickest);
  for (std::size_t k = node_order.size(); k-- > 0; posture = came_from[posture])
    posture_of_node[node_order[k]] = posture;
  return least;
}

std::vector<int> withEndNodes(const PostureTable& table, const std::vector<int>& order) {
  std::vector<int> nodes;
  nodes.reserve(order.size() + 2);
  if (table.startNode() >= 0) nodes.push_back(table.startNode());
  nodes.insert(nodes.end(), order.begin(), order.end());
  if (table.endNode() >= 0) nodes.push_back(table.endNode());
  return nodes;
}

BranchChoice bestBranches(const Route& route, const std::vector<int>& order) {
  BranchChoice choice;
  const std::vector<std::string> problems = findRouteProblems(route);
  choice.reason = problems.empty() ? orderProblem(route, order) : problems.front();
  if (!choice.reason.empty()) {
    choice.status = BranchChoiceStatus::kBadInput;
    return choice;
  }
  const PostureTable table(route);
  std::vector<int> posture_of_node(table.nodes(), -1);
  choice.travel_time = choosePostures(table, withEndNodes(table, order), posture_of_node);
  for (const int visit : order) choice.branches.push_back(posture_of_node[visit] - table.first(visit));
  choice.status = BranchChoiceStatus::kSolved;
  if (choice.travel_time >= kForbiddenTime) {
    choice.status = BranchChoiceStatus::kForbiddenMove;
    choice.reason = "every choice of branches contains a forbidden move";
    choice.travel_time = std::numeric_limits<double>::infinity();
  }
  return choice;
}

std::vector<int> serpentineOrder(const std::vector<int>& rows, const std::vector<int>& columns) {
  assert(rows.size() == columns.size());
  std::vector<int> order(rows.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return rows[a] != rows[b] ? rows[a] < rows[b] : columns[a] != columns[b] ? columns[a] < columns[b] : a < b;
  });
  bool backwards = false;
  for (auto begin = order.begin(); begin != order.end(); backwards = !backwards) {
    const auto end = std::find_if(begin, order.end(), [&](int visit) { return rows[visit] != rows[*begin]; });
    if (backwards) std::reverse(begin, end);
    begin = end;
  }
  return order;
}

}  // namespace tubeplan::planner
