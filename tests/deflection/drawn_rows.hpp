// Arms of random rows with many parallel or nearly parallel axes, for which the row conventions differ.
#pragma once

#include <algorithm>
#include <numbers>
#include <random>
#include <string>

#include "deflection/effects/rigid_frames.hpp"

namespace tubeplan::deflection::testing {

class DrawnRows {
 public:
  explicit DrawnRows(std::uint64_t seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
  Eigen::Vector3d vector(double most) { return {between(-most, most), between(-most, most), between(-most, most)}; }
  Eigen::VectorXd readings(const Arm& arm) {
    Eigen::VectorXd q(arm.jointCount());
    for (double& x : q) x = between(-3, 3);
    return q;
  }

  /// Returns a rigid arm with `rows` rows placed by origins; the first row has a joint.
  Arm arm(int rows, bool only_revolute = false) {
    Arm arm;
    for (int k = 0; k < rows; ++k) arm.rows.push_back(row(k, only_revolute));
    arm.p_LT = vector(0.3);
    return arm;
  }

 private:
  Eigen::Vector3d angles() {
    switch (static_cast<int>(between(0, 5))) {
      case 0:
        return vector(1.5);
      case 1:  // axes nearly parallel
        return {between(-1e-3, 1e-3), between(-1e-3, 1e-3), between(-3, 3)};
      case 2:  // axes nearly at right angles
        return {std::numbers::pi / 2 + between(-1e-3, 1e-3), between(-1e-3, 1e-3), 0};
      case 3:
        return {0, 0, between(-3, 3)};
      default:  // axes nearly opposite
        return {std::numbers::pi + between(-1e-4, 1e-4), 0, between(-3, 3)};
    }
  }

  Row<double> row(int k, bool only_revolute) {
    Row<double> row;
    row.name = "row" + std::to_string(k);
    row.placement = Origin<double>{vector(0.5), angles()};
    const double kind = k == 0 || only_revolute ? 0 : between(0, 1);
    row.joint.type = kind < 0.7 ? JointType::kRevolute : kind < 0.85 ? JointType::kPrismatic : JointType::kPassive;
    if (row.joint.type == JointType::kPassive) return row;
    row.joint.name = "q" + std::to_string(k);
    row.joint.offset = between(-1, 1);
    row.joint.lower = -3;
    row.joint.upper = 3;
    return row;
  }

  std::mt19937_64 random_;
};

/// Returns the largest difference between two forms of an arm at joint readings q. Tip positions [m], rotations of the
/// last rows and positions of lumped weights [m] are compared. Additional first rows of the second form are skipped.
inline double formDifference(const Arm& one, const Arm& other, const Eigen::VectorXd& q) {
  const auto a = rigidFramesOf<double>(one, q), b = rigidFramesOf<double>(other, q);
  double most = std::max((a.tip - b.tip).norm(), (a.rows.back().R - b.rows.back().R).norm());
  const std::size_t first = other.rows.size() - one.rows.size();
  for (std::size_t k = 0; k < one.rows.size(); ++k)
    for (std::size_t l = 0; l < one.rows[k].weight.lumps.size(); ++l) {
      const auto placed = [l](const auto& frame, const Row<double>& row) {
        return Eigen::Vector3d(frame.p + frame.R * row.weight.lumps[l].at);
      };
      most = std::max(most, (placed(a.rows[k], one.rows[k]) - placed(b.rows[first + k], other.rows[first + k])).norm());
    }
  return most;
}

inline double longestRow(const Arm& arm) {
  double longest = 0;
  for (const auto& row : arm.rows) longest = std::max(longest, offsetInPreviousAxes<double>(row).norm());
  return longest;
}

}  // namespace tubeplan::deflection::testing
