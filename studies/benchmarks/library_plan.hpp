// Plan of tube visits with OMPL and FCL alone.
//
// For each tube, the plan uses the first collision-free posture of the flexible inverse kinematics. The tubes are
// visited in nearest-neighbour order by the time of straight joint moves. Each travel is planned by OMPL's RRTConnect
// with default settings and OMPL's path simplification; FCL checks the postures at OMPL's default resolution. The
// program provides the costly parts: the deflected bodies, padded by the required clearance and their largest bow, and
// closed-form distances to the bowl and the planes, for which FCL has no fast shapes.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

#include "planner/workcell.hpp"

namespace tubeplan::benchmarks {

using Waypoints = std::vector<Eigen::VectorXd>;

/// Stopwatch of the wall and processor times since construction [s].
class Watch {
 public:
  [[nodiscard]] double wall() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  [[nodiscard]] double processor() const { return static_cast<double>(std::clock() - ticks_) / CLOCKS_PER_SEC; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  std::clock_t ticks_ = std::clock();
};

/// Result of planning with the libraries or with the program's own planner.
struct Outcome {
  std::string name;
  int visits = 0, requested = 0, detours = 0, failed = 0;
  double wall = 0, processor = 0;  ///< times [s]
  long checks = 0;                 ///< number of postures checked by FCL
  std::vector<Waypoints> travels;
};

struct LibraryOptions {
  std::uint64_t seed;
  double most_seconds;  ///< processor time after which no further travel is planned [s]
};

[[nodiscard]] Outcome planByLibraries(const planner::Workcell& cell, const std::vector<int>& tubes,
                                      const LibraryOptions& options);

}  // namespace tubeplan::benchmarks
