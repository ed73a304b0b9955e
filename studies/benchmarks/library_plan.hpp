// Plan of tube visits with OMPL and FCL alone.
//
// It uses the first free posture of the flexible inverse kinematics, and nearest neighbours by the time of the straight
// joint move. Each travel is by OMPL's RRTConnect with default settings and OMPL's own simplification, with postures
// checked by FCL at OMPL's default resolution. The costly parts are provided: the bent bodies, padded by the required
// clearance and their greatest bow, and the bowl and the planes in closed form, for which FCL has no fast shapes.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

#include "planner/workcell.hpp"

namespace tubeplan::benchmarks {

using Waypoints = std::vector<Eigen::VectorXd>;

/// Wall and processor time since construction [s].
class Watch {
 public:
  [[nodiscard]] double wall() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  [[nodiscard]] double processor() const { return static_cast<double>(std::clock() - ticks_) / CLOCKS_PER_SEC; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  std::clock_t ticks_ = std::clock();
};

/// Result of either way of planning.
struct Outcome {
  std::string name;
  int visits = 0, asked = 0, detours = 0, failed = 0;
  double wall = 0, processor = 0;  ///< [s]
  long checks = 0;                 ///< checks of postures by the library
  std::vector<Waypoints> travels;
};

struct LibraryOptions {
  std::uint64_t seed;
  double most_seconds;  ///< processor time after which no further travel is planned [s]
};

[[nodiscard]] Outcome planByLibraries(const planner::Workcell& cell, const std::vector<int>& tubes,
                                      const LibraryOptions& options);

}  // namespace tubeplan::benchmarks
