#include "deflection/free_motion.hpp"

#include <Eigen/Eigenvalues>

namespace tubeplan::deflection {

using Eigen::MatrixXd, Eigen::VectorXd;

VectorXd FreeMotion::take(const MatrixXd& slope, const VectorXd& wanted, double floor) {
  const MatrixXd free = slope * projector_;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(free * free.transpose());
  VectorXd step = VectorXd::Zero(projector_.cols());
  for (Eigen::Index k = 0; k < wanted.size(); ++k) {
    const double square = gram.eigenvalues()[k];
    if (!(square > floor * floor)) continue;
    const VectorXd motion = free.transpose() * gram.eigenvectors().col(k);
    step += motion * (gram.eigenvectors().col(k).dot(wanted) / square);
    projector_ -= motion * motion.transpose() / square;
  }
  return step;
}

}  // namespace tubeplan::deflection
