#include "deflection/posture_batch.hpp"

#include "deflection/resized.hpp"

namespace tubeplan::deflection {

using Eigen::Index, Eigen::Vector3d;

void PostureBatch::resize(Index joints, Index count, double load_of_all, const Vector3d& gravity_of_all) {
  resizeOrEmpty(q, joints, count);
  resizeOrEmpty(load, count, 1);
  resizeOrEmpty(gravity_B, 3, count);
  load.setConstant(load_of_all);
  gravity_B.colwise() = gravity_of_all;
}

PoseOf<double> TipBatch::X_BD(Index k) const {
  PoseOf<double> X;
  X.p = poses.col(k).head<3>();
  for (int column = 0; column < 3; ++column) X.R.col(column) = poses.col(k).segment<3>(3 + 3 * column);
  return X;
}

}  // namespace tubeplan::deflection
