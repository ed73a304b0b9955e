// The span of a matrix's columns, and the components of other vectors outside it.
#pragma once

#include <Eigen/Core>

namespace tubeplan::calibration {

/// Returns the part of `vector` that no linear combination of the columns can represent: its least-squares residual.
[[nodiscard]] Eigen::VectorXd partOutsideSpan(const Eigen::MatrixXd& columns, const Eigen::VectorXd& vector);

/// Returns an orthonormal basis of the span of the columns. The result does not depend on the scales of the columns.
[[nodiscard]] Eigen::MatrixXd spanOf(Eigen::MatrixXd columns);

/// Returns the components of `columns` that are orthogonal to the span of Q, whose columns are orthonormal.
[[nodiscard]] Eigen::MatrixXd without(const Eigen::MatrixXd& Q, const Eigen::MatrixXd& columns);

}  // namespace tubeplan::calibration
