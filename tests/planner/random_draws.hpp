// Random numbers and postures, identical with every standard library.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <random>

namespace tubeplan::planner::testing {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline double uniform(std::mt19937_64& generator, double low, double high) {
  return low + (high - low) * static_cast<double>(generator() >> 11) * 0x1.0p-53;
}

inline Eigen::VectorXd randomPosture(std::mt19937_64& generator, int joints, double low, double high) {
  Eigen::VectorXd q(joints);
  for (double& value : q) value = uniform(generator, low, high);
  return q;
}

}  // namespace tubeplan::planner::testing
