// The span of a Jacobian's columns, and the part of other columns outside it.
#pragma once

#include <Eigen/Core>

namespace tubeplan::calibration {

/// Returns an orthonormal basis of the columns' span. Dependent columns are dropped, and scales do not matter.
[[nodiscard]] Eigen::MatrixXd spanOf(Eigen::MatrixXd columns);

/// Returns the part of the columns that the orthonormal Q does not span.
[[nodiscard]] Eigen::MatrixXd without(const Eigen::MatrixXd& Q, const Eigen::MatrixXd& columns);

}  // namespace tubeplan::calibration
