// The span of a Jacobian's columns, and the components of other columns outside the span.
#pragma once

#include <Eigen/Core>

namespace tubeplan::calibration {

/// Returns the component of a vector that no linear combination of the columns can represent.
[[nodiscard]] Eigen::VectorXd leftBeside(const Eigen::MatrixXd& columns, const Eigen::VectorXd& vector);

/// Returns an orthonormal basis of the span of the columns. Linearly dependent columns add no basis vector, and the
/// scales of the columns do not matter.
[[nodiscard]] Eigen::MatrixXd spanOf(Eigen::MatrixXd columns);

/// Returns the component of the columns outside the span of the orthonormal Q.
[[nodiscard]] Eigen::MatrixXd without(const Eigen::MatrixXd& Q, const Eigen::MatrixXd& columns);

}  // namespace tubeplan::calibration
