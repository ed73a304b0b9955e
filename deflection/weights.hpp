// Total weights of rows and arms: sums of end weights, weights distributed over the undeflected members, and lumps.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

struct RowWeight {
  double weight = 0;                                   ///< [N]
  Eigen::Vector3d moment_R = Eigen::Vector3d::Zero();  ///< weight times centre position, in the row's frame [N m]
};

[[nodiscard]] RowWeight rowWeightOf(const Arm& arm, std::size_t row);

/// Returns the weight of all rows [N].
[[nodiscard]] double weightOf(const Arm& arm);

}  // namespace tubeplan::deflection
