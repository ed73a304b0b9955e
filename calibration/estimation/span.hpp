// The span of a Jacobian's columns, and the part of other columns outside it.
#pragma once

#include <Eigen/Core>

namespace tubeplan::calibration {

/// Returns what of a vector no combination of the columns can do.
[[nodiscard]] Eigen::VectorXd leftBeside(const Eigen::MatrixXd& columns, const Eigen::VectorXd& vector);

/// An orthonormal basis of what the columns span; columns that add nothing to the others cost nothing, and scales do
/// not matter.
[[nodiscard]] Eigen::MatrixXd spanOf(Eigen::MatrixXd columns);

/// Returns the part of the columns that the orthonormal Q does not span.
[[nodiscard]] Eigen::MatrixXd without(const Eigen::MatrixXd& Q, const Eigen::MatrixXd& columns);

}  // namespace tubeplan::calibration
