#include "deflection/inverse/free_motion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace tubeplan::deflection {

using Eigen::Dynamic, Eigen::Matrix, Eigen::VectorXd;

template <int Rows>
VectorXd FreeMotion::take(const Matrix<double, Dynamic, Dynamic, 0, Rows, Dynamic>& slope,
                          const Matrix<double, Dynamic, 1, 0, Rows, 1>& wanted, double floor) {
  using Square = Matrix<double, Dynamic, Dynamic, 0, Rows, Rows>;
  Matrix<double, Dynamic, Dynamic, 0, Rows, Dynamic> free(slope.rows(), slope.cols());
  free.noalias() = slope.lazyProduct(projector_);
  Square gram(slope.rows(), slope.rows());
  gram.noalias() = free.lazyProduct(free.transpose());
  // If every direction is clearly above the floor, all directions are used together; otherwise they are examined one by
  // one.
  const Eigen::LLT<Square> cholesky(gram);
  const Square inverse = cholesky.solve(Square::Identity(gram.rows(), gram.rows()));
  if (cholesky.info() == Eigen::Success && inverse.norm() * floor * floor < 1) {
    const Matrix<double, Dynamic, Dynamic, 0, Dynamic, Rows> back = free.transpose().lazyProduct(inverse);
    projector_.noalias() -= back.lazyProduct(free);
    return back.lazyProduct(wanted);
  }
  const Eigen::SelfAdjointEigenSolver<Square> directions(gram);
  VectorXd step = VectorXd::Zero(projector_.cols()), motion(projector_.cols());
  for (Eigen::Index k = 0; k < wanted.size(); ++k) {
    const double square = directions.eigenvalues()[k];
    if (!(square > floor * floor)) continue;
    motion.noalias() = free.transpose().lazyProduct(directions.eigenvectors().col(k));
    step += motion * (directions.eigenvectors().col(k).dot(wanted) / square);
    projector_.noalias() -= motion.lazyProduct(motion.transpose()) / square;
  }
  return step;
}

template VectorXd FreeMotion::take<3>(const Matrix<double, Dynamic, Dynamic, 0, 3, Dynamic>&,
                                      const Matrix<double, Dynamic, 1, 0, 3, 1>&, double);
template VectorXd FreeMotion::take<Dynamic>(const Eigen::MatrixXd&, const VectorXd&, double);

}  // namespace tubeplan::deflection
