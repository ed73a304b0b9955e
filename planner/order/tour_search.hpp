// Local search on the order of a route: 2-opt, Or-opt and branch changes, with local kicks. Internal to the ordering.
//
// The open route is stored as a closed tour, joined by anchors: the start and end postures and, unless both are given,
// one free anchor that costs nothing to reach. Edges between anchors are so cheap that no move removes them.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "planner/order/neighbour_lists.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

class TourSearch {
 public:
  TourSearch(const PostureTable& table, const std::vector<std::vector<Neighbour>>& neighbours);

  /// Starts from a route: `order` has all visits, `posture_of_node` the posture of every node.
  void restart(const std::vector<int>& order, const std::vector<int>& posture_of_node);
  /// Applies moves until no move of the neighbourhood reduces the time.
  void improve();
  /// Applies `count` local kicks one after the other, and keeps each kick that does not increase the time.
  void kick(long count, std::mt19937_64& random);

  [[nodiscard]] std::vector<int> order() const;  ///< indices of visits, first to last

 private:
  struct Change {  // either a range of positions reversed, or a node's posture replaced
    int node = -1;
    int first = 0, second = 0;
  };
  struct Segment {  // a segment of the tour: before, first .. last, after
    int before, first, last, after;
  };
  struct Junction {  // a position for insertion: a node with its two neighbours
    int node, beyond, behind;
  };
  static constexpr int kLongestInsertion = 3;
  struct Stretches {  // segments of increasing length, all with the same last node
    Segment segments[kLongestInsertion];
    double saved[kLongestInsertion];  // time saved by removing each segment and closing the tour [s]
    int size = 0;
  };
  enum class Side { kNext, kPrevious };

  [[nodiscard]] int size() const { return static_cast<int>(tour_.size()); }
  [[nodiscard]] int next(int node) const { return tour_[place_[node] + 1 == size() ? 0 : place_[node] + 1]; }
  [[nodiscard]] int previous(int node) const { return tour_[place_[node] == 0 ? size() - 1 : place_[node] - 1]; }
  [[nodiscard]] int adjacent(int node, Side side) const { return side == Side::kNext ? next(node) : previous(node); }
  [[nodiscard]] double cost(int node_a, int node_b) const { return costAt(node_a, posture_of_node_[node_a], node_b); }
  [[nodiscard]] double costAt(int node_a, int posture_a, int node_b) const {
    if (node_a < visits_ && node_b < visits_) return table_.cost(posture_a, posture_of_node_[node_b]);
    return costAtAnchor(node_a, posture_a, node_b);
  }
  [[nodiscard]] double costAtAnchor(int node_a, int posture_a, int node_b) const;

  /// Computes the cost from each posture of `node_a` to the current posture of `node_b` [s].
  void costsFrom(int node_a, int node_b, Eigen::ArrayXd& times) const;

  void improveDirty();
  bool improveNode(int node);
  bool changeBranch(int node);
  bool moveFrom(int node, Side side);
  [[nodiscard]] Stretches stretchesEndingAt(int a, int b, Side side) const;
  bool tryTwoOpt(int a, int b, const Junction& at, double gain_so_far);
  bool tryOrOpt(const Stretches& stretches, const Junction& at, double gain_so_far);
  bool tryOtherBranch(const Stretches& stretches, const Junction& at, double now);
  bool insert(const Segment& segment, int c, int d, bool keeps_sense, double gain);
  bool swapSegments(std::mt19937_64& random);
  bool switchBranches(std::mt19937_64& random);

  void exchange(int a, int b, int c, int d);
  void moveSegment(const Segment& segment, int c, int d, bool keeps_sense);
  void reversePlaces(int from, int to);
  void setPosture(int node, int posture);
  void undo();
  void markDirty(int node);

  const PostureTable& table_;
  const std::vector<std::vector<Neighbour>>& neighbours_;
  int visits_;
  int free_anchor_ = -1;
  std::vector<int> tour_, place_, posture_of_node_;
  std::vector<Change> changes_;  // changes since the last kick, for undo()
  double gained_ = 0;            // time gained since the last kick [s]
  Eigen::ArrayXd times_, other_times_;
  std::vector<int> dirty_;
  std::vector<char> is_dirty_;
};

}  // namespace tubeplan::planner
