// The quickest order of a few tubes: exact for the known times of moves, which are refined until all moves that it
// chooses are known. Internal to the planning of visits.
//
// The time of a move along the straight line is known at once. The rough time of a detour has a cost, and the time of
// its optimised form costs ten times that. So each is computed only if the quickest order depends on it. The gain of
// optimising a rough detour varies: orders are searched by expected and by optimistic times in turn, at last by lower
// bounds of the times. The quickest of all orders that were planned in full is the result.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "planner/order/posture_table.hpp"
#include "planner/real_order.hpp"

namespace tubeplan::planner {

class FewTubes {
 public:
  /// `zones` has one number for each visit, or is empty; if it is empty or constant, any order is allowed.
  FewTubes(const PlanContext& context, const VisitChoice& choice, const PostureTable& table,
           const std::vector<int>& zones, TravelNetwork& network);

  /// Returns the order, as orderWithRealMoves(). A move between parts of the free space is avoided like any impossible
  /// move; the order is parted if every order has such a move.
  [[nodiscard]] RealOrder order();

 private:
  enum class Knowledge : char { kStraight, kEstimated, kExact };

  /// A move of an order, between postures of the table.
  struct Move {
    int from, to;
  };

  /// Returns how well the move from posture p to q is known.
  [[nodiscard]] Knowledge& knowledgeOf(int p, int q) {
    return knowledge_[static_cast<std::size_t>(p * table_.postures() + q)];
  }
  [[nodiscard]] std::vector<Move> movesBelow(const std::vector<int>& postures, Knowledge knowledge);
  /// Sets the time of a move. `rough` is the time [s] of a detour found but not yet optimised; otherwise the time
  /// itself.
  void setTime(Move move, double rough, Knowledge knowledge);
  void estimate(const std::vector<Move>& moves);
  void plan(const std::vector<Move>& moves);
  [[nodiscard]] bool isSpent() const { return estimates_left_ <= 0 || checks_left_ <= 0; }
  void noteApart(bool is_apart, const Clearance& tightest);
  void takePartsAsApart();
  void expectTheUnknownToBeAsTheKnown();
  void showProgress(const std::vector<int>& postures, std::size_t open) const;
  [[nodiscard]] double timeOf(const std::vector<int>& postures) const;  ///< time of moves that are known exactly [s]
  [[nodiscard]] std::vector<Stop> stopsOf(const std::vector<int>& postures) const;

  const PlanContext& context_;
  const PostureTable& table_;
  const std::vector<int>& zones_;
  TravelNetwork& network_;
  std::vector<Stop> stops_;  // stop of each posture
  Eigen::MatrixXd straight_;
  std::array<Eigen::MatrixXd, 3> times_;  // expected times, optimistic times, lower bounds [s]
  std::vector<Knowledge> knowledge_;
  int estimates_left_;
  long checks_left_;  // postures left to check, for estimates
  bool is_parted_ = false, has_parts_ = false;
  Clearance between_;
};

}  // namespace tubeplan::planner
