// The quickest order of a few tubes: exact for the times of moves known so far, and repeated until all moves of the
// chosen order are planned. Internal to the planning of visits.
//
// The time of a move along the straight line is known at once. The rough time of a detour takes some computing time,
// and the time of the optimised detour ten times as much. Each is therefore computed only if the quickest order depends
// on it. Because the gain from optimising a detour varies, orders are searched with expected and with optimistic times
// in turn, and finally with lower bounds of the times. The result is the quickest of all orders that were planned in
// full.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "planner/order/posture_table.hpp"
#include "planner/real_order.hpp"

namespace tubeplan::planner {

class FewTubes {
 public:
  /// `zones` has the zone of each visit, or is empty; if it is empty or constant, any order is allowed.
  FewTubes(const PlanContext& context, const VisitChoice& choice, const PostureTable& table,
           const std::vector<int>& zones, TravelNetwork& network);

  /// Returns the order, as orderWithRealMoves() does. A move between disconnected parts of the free space is avoided
  /// like any impossible move; `is_parted` is true if every order has such a move.
  [[nodiscard]] RealOrder order();

 private:
  enum class Knowledge : char { kStraight, kEstimated, kExact };

  /// A move of an order, between postures of the table.
  struct Move {
    int from, to;
  };

  /// Returns a reference to how well the move between postures p and q is known.
  [[nodiscard]] Knowledge& knowledgeOf(int p, int q) {
    return knowledge_[static_cast<std::size_t>(p * table_.postures() + q)];
  }
  [[nodiscard]] std::vector<Move> movesBelow(const std::vector<int>& postures, Knowledge knowledge);
  /// Sets the time of a move [s]. `rough` is the time of a detour that is found but not yet optimised; if the knowledge
  /// is exact, it is the move's time.
  void setTime(Move move, double rough, Knowledge knowledge);
  void estimate(const std::vector<Move>& moves);
  void plan(const std::vector<Move>& moves);
  [[nodiscard]] bool isSpent() const { return estimates_left_ <= 0 || checks_left_ <= 0; }
  void noteApart(bool is_apart, const Clearance& tightest);
  void takePartsAsApart();
  void expectTheUnknownToBeAsTheKnown();
  void showProgress(const std::vector<int>& postures, std::size_t open) const;
  /// Returns the time of moves that are all known exactly [s].
  [[nodiscard]] double timeOf(const std::vector<int>& postures) const;
  [[nodiscard]] std::vector<Stop> stopsOf(const std::vector<int>& postures) const;

  const PlanContext& context_;
  const PostureTable& table_;
  const std::vector<int>& zones_;
  TravelNetwork& network_;
  std::vector<Stop> stops_;  // stop of each posture of the table
  Eigen::MatrixXd straight_;
  std::array<Eigen::MatrixXd, 3> times_;  // expected times, optimistic times, lower bounds [s]
  std::vector<Knowledge> knowledge_;
  int estimates_left_;
  long checks_left_;  // number of postures left to check for estimates
  bool is_parted_ = false, has_parts_ = false;
  Clearance between_;
};

}  // namespace tubeplan::planner
