// Free postures joined by straight moves that were proved free: made once for an arm among its obstacles, and asked for
// every way round (probabilistic roadmap: Kavraki, Svestka, Latombe and Overmars 1996).
//
// What it answers depends on the scene, its own seed and the postures that it was bridged for, never on which ways were
// asked for before.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "planner/motion/motion_planner.hpp"

namespace tubeplan::planner {

struct RoadmapOptions {
  std::uint64_t seed = 1;
  int random_postures = 1200;  ///< anywhere within the limits, beside those given
  int neighbours = 12;         ///< that a posture is joined to where the way is free
  int attachments = 24;        ///< postures tried to join an end to
  MotionCheckOptions check = {};
};

enum class RoadmapStatus {
  kNotRun,
  kFound,
  kApart,       ///< both ends are joined to it, but to parts that no edge joins
  kUnattached,  ///< an end is joined to none of its postures
};

struct RoadmapWay {
  RoadmapStatus status = RoadmapStatus::kNotRun;
  std::vector<Eigen::VectorXd> waypoints;  ///< both ends included; each stretch proved free
};

class Roadmap {
 public:
  /// `postures` [rad]: where travels begin and end, say; blocked ones are left out. The problem must have a cost.
  Roadmap(const MotionProblem& problem, std::vector<Eigen::VectorXd> postures, const RoadmapOptions& options = {});

  /// The quickest way over its edges. Const use from several threads is safe where the problem's functions are.
  [[nodiscard]] RoadmapWay between(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, long& checks) const;

  /// The part of the free space that each posture lies in, as far as the edges and the postures themselves join it:
  /// numbers from 0, -1 for one that is joined to nothing.
  [[nodiscard]] std::vector<int> partsOf(const std::vector<Eigen::VectorXd>& postures) const;

  /// Searches ways between the parts that these postures lie in, where no edge joins them: from each to the one with
  /// the most of the postures, between postures that are near each other. True where one was found; it is edges from
  /// then on.
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
  /// The lowest node of each node's part, with the parts that a list of attachments joins taken as one.
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
