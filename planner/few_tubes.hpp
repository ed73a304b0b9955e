// The order of so few tubes that the quickest can be had: exact for what is known of the moves, and more is asked about
// them until those that it chooses are known. Internal to the planning of visits.
//
// Of a move the time along the straight line is known at once; the time of a way round, roughly, at some cost; what it
// takes once it is made quick at ten times that. So each is asked for only where the quickest order hangs on it. How
// much a rough way gains varies: orders are sought by what is to be expected and by what may be hoped in turn, at last
// by the very least that moves can take, and of all that were planned in full the quickest is taken.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "planner/order/posture_table.hpp"
#include "planner/real_order.hpp"

namespace tubeplan::planner {

class FewTubes {
 public:
  /// `zones` has one number for each visit, empty or all the same: any order will do.
  FewTubes(const PlanContext& context, const VisitChoice& choice, const PostureTable& table,
           const std::vector<int>& zones, TravelNetwork& network);

  /// As orderWithRealMoves. A move between parts of the free space is avoided as any that cannot be made; the order is
  /// parted where every one has such a move.
  [[nodiscard]] RealOrder order();

 private:
  enum class Knowledge : char { kStraight, kEstimated, kExact };

  /// One of the moves of an order, between postures of the table.
  struct Move {
    int from, to;
  };

  /// Of the move from posture p to q.
  [[nodiscard]] Knowledge& knowledgeOf(int p, int q) {
    return knowledge_[static_cast<std::size_t>(p * table_.postures() + q)];
  }
  [[nodiscard]] std::vector<Move> movesBelow(const std::vector<int>& postures, Knowledge knowledge);
  /// `rough` is the time [s] of a way that was found, where it is yet to be made quick; else the time itself.
  void setTime(Move move, double rough, Knowledge knowledge);
  void estimate(const std::vector<Move>& moves);
  void plan(const std::vector<Move>& moves);
  [[nodiscard]] bool isSpent() const { return estimates_left_ <= 0 || checks_left_ <= 0; }
  void noteApart(bool is_apart, const Clearance& tightest);
  void takePartsAsApart();
  void expectTheUnknownToBeAsTheKnown();
  void showProgress(const std::vector<int>& postures, std::size_t open) const;
  [[nodiscard]] double timeOf(const std::vector<int>& postures) const;  ///< s, of moves that are known exactly
  [[nodiscard]] std::vector<Stop> stopsOf(const std::vector<int>& postures) const;

  const PlanContext& context_;
  const PostureTable& table_;
  const std::vector<int>& zones_;
  TravelNetwork& network_;
  std::vector<Stop> stops_;  // by posture
  Eigen::MatrixXd straight_;
  std::array<Eigen::MatrixXd, 3> times_;  // as is to be expected, as may be hoped, and at the very least
  std::vector<Knowledge> knowledge_;
  int estimates_left_;
  long checks_left_;  // of postures, for estimates
  bool is_parted_ = false, has_parts_ = false;
  Clearance between_;
};

}  // namespace tubeplan::planner
