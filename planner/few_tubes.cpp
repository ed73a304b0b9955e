#include "planner/few_tubes.hpp"

#include <algorithm>
#include <cmath>

#include "planner/order/exact_order.hpp"

namespace tubeplan::planner {

namespace {

// Largest number of moves whose time is estimated: kEstimates plus kEstimatesPerPair for each pair of nodes.
constexpr int kEstimates = 20, kEstimatesPerPair = 10;
constexpr long kMostChecks = 1'000'000;  // largest number of postures checked for all estimates together
constexpr double kRounding = 1e-12;      // rounding error of a sum of times in a different order
// Assumed fraction of the extra time of a rough detour, compared with the straight move, that remains after
// optimisation: for expected times, optimistic times and lower bounds. Measured for three arms, the fraction is 0.6 to
// 0.7 on average, with a standard deviation of 0.2.
constexpr std::array kExcessLeft{0.6, 0.2, 0.0};
// The search alternates between the first two fractions. It uses the last one once the quickest orders for both are
// known.
constexpr std::size_t kTakenInTurn = 2;

std::vector<Stop> stopsOf(const PostureTable& table, const VisitChoice& choice) {
  std::vector<Stop> stops;
  for (int p = 0; p < table.postures(); ++p) {
    const int node = table.nodeOf(p);
    if (node == table.startNode() || node == table.endNode())
      stops.push_back({node == table.startNode() ? kStartPosture : kEndPosture, 0});
    else
      stops.push_back(
          {node, choice.branches[static_cast<std::size_t>(node)][static_cast<std::size_t>(p - table.first(node))]});
  }
  return stops;
}

}  // namespace

FewTubes::FewTubes(const PlanContext& context, const VisitChoice& choice, const PostureTable& table,
                   const std::vector<int>& zones, TravelNetwork& network)
    : context_(context),
      table_(table),
      zones_(zones),
      network_(network),
      stops_(planner::stopsOf(table, choice)),
      straight_(straightTimes(table)),
      times_{straight_, straight_, straight_},
      knowledge_(static_cast<std::size_t>(table.postures() * table.postures()), Knowledge::kStraight),
      estimates_left_(kEstimates + kEstimatesPerPair * table.nodes() * (table.nodes() - 1) / 2),
      checks_left_(kMostChecks) {}

RealOrder FewTubes::order() {
  RealOrder best;
  double least = std::numeric_limits<double>::infinity();
  std::size_t view = 0, settled = 0;  // settled: number of time matrices for which the quickest order is known
  for (int rounds = 0; rounds < context_.options.reprice_rounds && !context_.isStopped();) {
    const ExactOrder order = exactOrder(table_, times_[view], zones_);
    if (std::isnan(best.lower_bound)) best.lower_bound = order.time * (1 - kRounding);
    const std::vector<Move> unknown = movesBelow(order.postures, Knowledge::kEstimated);
    if (!unknown.empty() && !isSpent()) {
      showProgress(order.postures, unknown.size());
      estimate(unknown);
      continue;
    }
    const std::vector<Move> open = movesBelow(order.postures, Knowledge::kExact);
    showProgress(order.postures, open.size());
    plan(open);
    const double time = timeOf(order.postures);
    if (time < least || best.stops.empty()) best.stops = stopsOf(order.postures);
    least = std::min(least, time);
    rounds += open.empty() ? 0 : 1;
    settled = open.empty() ? settled + 1 : settled / kTakenInTurn * kTakenInTurn;
    if (settled == times_.size()) break;
    view = settled < kTakenInTurn ? (view + 1) % kTakenInTurn : settled;
  }
  best.is_parted = is_parted_ && !(least < kForbiddenTime);
  best.between = between_;
  return best;
}

/// Returns the moves of an order whose times are not yet known at the level `knowledge`.
std::vector<FewTubes::Move> FewTubes::movesBelow(const std::vector<int>& postures, Knowledge knowledge) {
  std::vector<Move> moves;
  for (std::size_t k = 0; k + 1 < postures.size(); ++k)
    if (knowledgeOf(postures[k], postures[k + 1]) < knowledge) moves.push_back({postures[k], postures[k + 1]});
  return moves;
}

void FewTubes::setTime(Move move, double rough, Knowledge knowledge) {
  const double straight = straight_(move.from, move.to);
  for (std::size_t view = 0; view < times_.size(); ++view) {
    const double excess_share = knowledge == Knowledge::kExact ? 1 : kExcessLeft[view];
    const double time = std::min(straight + excess_share * (rough - straight), kForbiddenTime);
    times_[view](move.from, move.to) = times_[view](move.to, move.from) = time;
  }
  knowledgeOf(move.from, move.to) = knowledgeOf(move.to, move.from) = knowledge;
}

void FewTubes::estimate(const std::vector<Move>& moves) {
  for (const Move& move : moves) {
    if (context_.isStopped()) return;
    const TravelEstimate found =
        network_.estimate(stops_[static_cast<std::size_t>(move.from)], stops_[static_cast<std::size_t>(move.to)]);
    setTime(move, found.time, found.is_exact ? Knowledge::kExact : Knowledge::kEstimated);
    --estimates_left_;
    checks_left_ -= found.checks;
    noteDisconnected(found.is_disconnected, found.tightest);
  }
  if (is_parted_ && !has_parts_) forbidMovesBetweenParts();
  if (isSpent()) scaleUnknownTimes();
}

void FewTubes::plan(const std::vector<Move>& moves) {
  for (const Move& move : moves) {
    if (context_.isStopped()) return;
    const MotionPlan& travel =
        network_.between(stops_[static_cast<std::size_t>(move.from)], stops_[static_cast<std::size_t>(move.to)]);
    setTime(move, network_.timeOf(travel), Knowledge::kExact);
    noteDisconnected(travel.is_disconnected, travel.tightest);
    context_.keepCache();
  }
}

void FewTubes::noteDisconnected(bool is_disconnected, const Clearance& tightest) {
  if (!is_disconnected || is_parted_) return;
  is_parted_ = true;
  between_ = tightest;
}

/// Marks all moves between disconnected parts of the free space as forbidden, once the first such move is found. This
/// saves trying each of them.
void FewTubes::forbidMovesBetweenParts() {
  has_parts_ = true;
  const std::vector<int> parts = network_.partsOf(stops_);
  for (int p = 0; p < table_.postures(); ++p)
    for (int q = 0; q < p; ++q) {
      const int a = parts[static_cast<std::size_t>(p)], b = parts[static_cast<std::size_t>(q)];
      const bool is_unknown = knowledgeOf(p, q) == Knowledge::kStraight;
      if (is_unknown && a >= 0 && b >= 0 && a != b) setTime({p, q}, kForbiddenTime, Knowledge::kExact);
    }
}

/// Sets the times of moves that have not been estimated, once no more estimates are allowed: the straight time
/// multiplied by the ratio of known to straight times of all other moves.
void FewTubes::scaleUnknownTimes() {
  const auto isKnown = [this](int p, int q) { return knowledgeOf(p, q) != Knowledge::kStraight; };
  for (Eigen::MatrixXd& times : times_) {
    double known = 0, straight = 0;
    for (int p = 0; p < table_.postures(); ++p)
      for (int q = 0; q < p; ++q)
        if (isKnown(p, q) && times(p, q) < kForbiddenTime) {
          known += times(p, q);
          straight += straight_(p, q);
        }
    if (!(straight > 0)) continue;
    for (int p = 0; p < table_.postures(); ++p)
      for (int q = 0; q < table_.postures(); ++q)
        if (!isKnown(p, q)) times(p, q) = straight_(p, q) * (known / straight);
  }
}

void FewTubes::showProgress(const std::vector<int>& postures, std::size_t open) const {
  const std::size_t moves = postures.empty() ? 0 : postures.size() - 1;
  context_.showProgress("travel", moves - open, moves);
}

double FewTubes::timeOf(const std::vector<int>& postures) const {
  double time = 0;
  for (std::size_t k = 0; k + 1 < postures.size(); ++k) time += times_[0](postures[k], postures[k + 1]);
  return time;
}

std::vector<Stop> FewTubes::stopsOf(const std::vector<int>& postures) const {
  std::vector<Stop> stops;
  for (const int posture : postures) stops.push_back(stops_[static_cast<std::size_t>(posture)]);
  return stops;
}

}  // namespace tubeplan::planner
