// Tubes visited as one would plan it with OMPL and FCL alone.
//
// The first posture of the flexible inverse kinematics that is free, nearest neighbour by the time of the straight
// joint move, each travel by OMPL's RRTConnect with default settings and OMPL's own simplification, postures checked by
// FCL at OMPL's default resolution. It is given what would cost it dear: the bent bodies, padded by the clearance asked
// for and their greatest bow; and the bowl and the planes, which FCL has no quick shapes for, in closed form.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

#include "planner/workcell.hpp"

namespace tubeplan::benchmarks {

using Waypoints = std::vector<Eigen::VectorXd>;

/// Wall and processor time since it was made.
class Watch {
 public:
  [[nodiscard]] double wall() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  [[nodiscard]] double processor() const { return static_cast<double>(std::clock() - ticks_) / CLOCKS_PER_SEC; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  std::clock_t ticks_ = std::clock();
};

/// What either way of planning comes to.
struct Outcome {
  std::string name;
  int visits = 0, asked = 0, detours = 0, failed = 0;
  double wall = 0, processor = 0;  ///< s
  long checks = 0;                 ///< of postures by the library
  std::vector<Waypoints> travels;
};

struct LibraryOptions {
  std::uint64_t seed;
  double most_seconds;  ///< of processor time, after which no further travel is planned
};

[[nodiscard]] Outcome planByLibraries(const planner::Workcell& cell, const std::vector<int>& tubes,
                                      const LibraryOptions& options);

}  // namespace tubeplan::benchmarks
