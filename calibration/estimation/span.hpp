// What the columns of a Jacobian can follow, and what is left of others beside it.
#pragma once

#include <Eigen/Core>

namespace tubeplan::calibration {

/// An orthonormal basis of what the columns span; columns that add nothing to the others cost nothing, and scales do
/// not matter.
[[nodiscard]] Eigen::MatrixXd spanOf(Eigen::MatrixXd columns);

/// The part of columns that the orthonormal Q does not span.
[[nodiscard]] Eigen::MatrixXd without(const Eigen::MatrixXd& Q, const Eigen::MatrixXd& columns);

}  // namespace tubeplan::calibration
