// What a row and an arm weigh: end weight, distributed weight over the undeflected member, and lumps, as one.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

struct RowWeight {
  double weight = 0;                                   ///< N
  Eigen::Vector3d moment_R = Eigen::Vector3d::Zero();  ///< N m: weight times its centre in the row's frame
};

[[nodiscard]] RowWeight rowWeightOf(const Arm& arm, std::size_t row);

/// All rows, N.
[[nodiscard]] double weightOf(const Arm& arm);

}  // namespace tubeplan::deflection
