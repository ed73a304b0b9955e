// Free postures connected by straight moves that are proved free: built once for an arm and its obstacles, and used for
// every detour (probabilistic roadmap: Kavraki, Svestka, Latombe and Overmars 1996).
//
// The results of a roadmap depend only on the scene, the seed and the postures passed to bridge(), not on earlier
// queries.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "planner/motion/motion_planner.hpp"

namespace tubeplan::planner {

struct RoadmapOptions {
  std::uint64_t seed = 1;
  /// Number of free postures drawn within the joint limits, in addition to the given postures.
  int random_postures = 1200;
  int neighbours = 12;   ///< number of nearest postures that each posture is connected to, if the move is free
  int attachments = 24;  ///< number of nearest postures tried to attach a start or goal
  MotionCheckOptions check = {};
};

enum class RoadmapStatus {
  kNotRun,
  kFound,
  kDisconnected,  ///< start and goal are both attached, but to disconnected parts of the roadmap
  kUnattached,    ///< the start or the goal cannot be attached to any posture
};

struct RoadmapWay {
  RoadmapStatus status = RoadmapStatus::kNotRun;
  /// Path with start and goal included, each segment proved free; empty unless found.
  std::vector<Eigen::VectorXd> waypoints;
};

class Roadmap {
 public:
  /// Builds the roadmap. `postures` [rad], such as ends of travels, become nodes unless they are blocked. The problem
  /// must have a cost function.
  Roadmap(const MotionProblem& problem, std::vector<Eigen::VectorXd> postures, const RoadmapOptions& options = {});

  /// Returns the fastest path from q0 to q1 along the edges, and adds the number of postures checked to `checks`. Const
  /// use from several threads is safe if the problem's functions are.
  [[nodiscard]] RoadmapWay between(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, long& checks) const;

  /// For each posture, returns the 0-based number of the connected component of the roadmap that it is attached to; -1
  /// if it cannot be attached. A posture that is attached to two parts connects them.
  [[nodiscard]] std::vector<int> partsOf(const std::vector<Eigen::VectorXd>& postures) const;

  /// Searches for connections between the disconnected parts that `postures` are attached to: between close nodes of
  /// each part and of the part with the most of these postures. Returns true if a connection was found; its moves
  /// become edges.
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
  /// For each node, returns the lowest node index in its part; parts to which the same posture is attached are merged.
  /// `joined` has the attachments of each posture.
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
