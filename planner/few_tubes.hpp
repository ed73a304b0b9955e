// Search for the quickest order of a few tubes: an exact search with the times of moves known so far, repeated until
// all moves of the order found have been planned. Internal to the planning of visits.
//
// The time of a move along the straight line is known at once. The rough time of a detour is slower to compute, and the
// time of an optimised detour ten times slower still. Each is therefore computed only if the quickest order depends on
// it. Because the gain from optimising a detour varies, the search alternates between expected and optimistic times,
// and finally uses lower bounds. The result is the quickest of all orders that were planned in full.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "planner/order/posture_table.hpp"
#include "planner/real_order.hpp"

namespace tubeplan::planner {

class FewTubes {
 public:
  /// `zones` has the zone of each visit. If it is empty or constant, any order is allowed.
  FewTubes(const PlanContext& context, const VisitChoice& choice, const PostureTable& table,
           const std::vector<int>& zones, TravelNetwork& network);

  /// Returns the order, as orderWithRealMoves() does. Moves between disconnected parts of the free space are treated as
  /// impossible; `is_parted` is true if every order found needs one.
  [[nodiscard]] RealOrder order();

 private:
  enum class Knowledge : char { kStraight, kEstimated, kExact };

  /// A move between two postures of the table.
  struct Move {
    int from, to;
  };

  /// Returns a reference to the state of knowledge about the time of the move between postures p and q.
  [[nodiscard]] Knowledge& knowledgeOf(int p, int q) {
    return knowledge_[static_cast<std::size_t>(p * table_.postures() + q)];
  }
  [[nodiscard]] std::vector<Move> movesBelow(const std::vector<int>& postures, Knowledge knowledge);
  /// Sets the time of a move [s] in all tables. `rough` is the time of a detour that is not yet optimised or, if
  /// `knowledge` is kExact, the final time of the move.
  void setTime(Move move, double rough, Knowledge knowledge);
  void estimate(const std::vector<Move>& moves);
  void plan(const std::vector<Move>& moves);
  [[nodiscard]] bool isSpent() const { return estimates_left_ <= 0 || checks_left_ <= 0; }
  void noteDisconnected(bool is_disconnected, const Clearance& tightest);
  void forbidMovesBetweenParts();
  void scaleUnknownTimes();
  void showProgress(const std::vector<int>& postures, std::size_t open) const;
  /// Returns the travel time [s] of an order whose moves all have exactly known times.
  [[nodiscard]] double timeOf(const std::vector<int>& postures) const;
  [[nodiscard]] std::vector<Stop> stopsOf(const std::vector<int>& postures) const;

  const PlanContext& context_;
  const PostureTable& table_;
  const std::vector<int>& zones_;
  TravelNetwork& network_;
  std::vector<Stop> stops_;  // for each posture of the table, the stop that it belongs to
  Eigen::MatrixXd straight_;
  std::array<Eigen::MatrixXd, 3> times_;  // expected times, optimistic times, lower bounds [s]
  std::vector<Knowledge> knowledge_;
  int estimates_left_;
  long checks_left_;  // number of postures that estimates may still check
  bool is_parted_ = false, has_parts_ = false;
  Clearance between_;
};

}  // namespace tubeplan::planner
