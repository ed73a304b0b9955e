// Free postures joined by straight moves that were proved free: built once for an arm among its obstacles, and used for
// every detour (probabilistic roadmap: Kavraki, Svestka, Latombe and Overmars 1996).
//
// Its answers depend on the scene, its own seed and the postures that it was bridged for, never on earlier queries.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "planner/motion/motion_planner.hpp"

namespace tubeplan::planner {

struct RoadmapOptions {
  std::uint64_t seed = 1;
  int random_postures = 1200;  ///< anywhere within the limits, in addition to those given
  int neighbours = 12;         ///< number of neighbours to which a posture is joined if the move is free
  int attachments = 24;        ///< number of postures tried to join an end
  MotionCheckOptions check = {};
};

enum class RoadmapStatus {
  kNotRun,
  kFound,
  kApart,       ///< both ends are joined to it, but to parts without a connection
  kUnattached,  ///< an end is joined to none of its postures
};

struct RoadmapWay {
  RoadmapStatus status = RoadmapStatus::kNotRun;
  std::vector<Eigen::VectorXd> waypoints;  ///< both ends included; each stretch is proved free
};

class Roadmap {
 public:
  /// `postures` [rad], such as ends of travels, become nodes; blocked ones are left out. The problem must have a cost.
  Roadmap(const MotionProblem& problem, std::vector<Eigen::VectorXd> postures, const RoadmapOptions& options = {});

  /// Returns the quickest path over its edges. Const use from several threads is safe if the problem's functions are.
  [[nodiscard]] RoadmapWay between(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, long& checks) const;

  /// Returns the part of the free space of each posture, as connected by edges and the postures themselves: numbers
  /// from 0, -1 for a posture that is joined to nothing.
  [[nodiscard]] std::vector<int> partsOf(const std::vector<Eigen::VectorXd>& postures) const;

  /// Searches connections between the parts of these postures that no edge joins: from each part to the one with the
  /// most of the postures, between postures near each other. Returns true if one was found; it then becomes edges.
  bool bridge(const std::vector<Eigen::VectorXd>& postures, const MotionPlannerOptions& options);

  [[nodiscard]] int postures() const { return static_cast<int>(postures_.size()); }
  [[nodiscard]] int edges() const;

 private:
  struct Edge {
    int to;
    double cost;
  };
  struct Candidate {
    int from, to;
    double cost;
  };

  void addRandomPostures();
  [[nodiscard]] std::vector<Candidate> candidates() const;
  void join();
  [[nodiscard]] std::vector<std::vector<Edge>> attachAll(const std::vector<Eigen::VectorXd>& postures) const;
  /// Returns the lowest node of each node's part, with the parts that a list of attachments joins merged.
  [[nodiscard]] std::vector<int> rootsWith(const std::vector<std::vector<Edge>>& joined) const;
  [[nodiscard]] std::vector<Eigen::VectorXd> wayBetween(const std::vector<int>& from, const std::vector<int>& to,
                                                        MotionPlannerOptions options) const;
  void addWay(const std::vector<Eigen::VectorXd>& way);
  [[nodiscard]] std::vector<Edge> attach(const Eigen::VectorXd& q, long& checks) const;
  [[nodiscard]] std::vector<int> quickest(const std::vector<Edge>& from, const std::vector<Edge>& to) const;

  MotionProblem problem_;
  RoadmapOptions options_;
  std::vector<Eigen::VectorXd> postures_;
  std::vector<std::vector<Edge>> edges_;
};

}  // namespace tubeplan::planner
