#include "planner/reach/tip_prediction.hpp"

namespace tubeplan::planner {

using Eigen::Vector3d, Eigen::VectorXd;

TipPrediction::TipPrediction(const Workcell& cell)
    : cell_(cell), gravity_B_(deflection::gravityInBase(cell.arm, cell.X_WB)), kinematics_(cell.arm) {}

PredictedTip TipPrediction::at(const VectorXd& q) {
  postures_.resize(q.size(), 1, cell_.load, gravity_B_);
  postures_.q.col(0) = q;
  kinematics_.solve(postures_, tips_, {1e-13, 100});
  const auto X_BD = tips_.X_BD(0);
  const Vector3d axis_W = cell_.X_WB.linear() * X_BD.R * cell_.arm.tool_axis_L;
  return {cell_.X_WB * X_BD.p, std::atan2(axis_W.cross(kHoleAxis_W).norm(), axis_W.dot(kHoleAxis_W)), axis_W};
}

double TipPrediction::lateralDeviation(const Vector3d& hole_W, const std::vector<VectorXd>& postures, int samples) {
  if (postures.size() < 2) return 0;
  const auto stretches = static_cast<Eigen::Index>(postures.size()) - 1;
  postures_.resize(postures.front().size(), stretches * samples + 1, cell_.load, gravity_B_);
  for (Eigen::Index k = 0; k < stretches; ++k) {
    const VectorXd &from = postures[static_cast<std::size_t>(k)], &to = postures[static_cast<std::size_t>(k) + 1];
    for (int s = 0; s <= samples; ++s) {
      const double share = static_cast<double>(s) / samples;
      postures_.q.col(k * samples + s) = (1 - share) * from + share * to;
    }
  }
  kinematics_.solve(postures_, tips_, {1e-13, 100});
  double worst = 0;
  for (Eigen::Index k = 0; k < postures_.size(); ++k)
    worst = worseOf(worst, (cell_.X_WB * Vector3d(tips_.poses.col(k).head<3>()) - hole_W).head<2>().norm());
  return worst;
}

PredictedTip predictTip(const Workcell& cell, const VectorXd& q) { return TipPrediction(cell).at(q); }

double lateralDeviation(const Workcell& cell, const Vector3d& hole_W, const std::vector<VectorXd>& postures,
                        int samples) {
  return TipPrediction(cell).lateralDeviation(hole_W, postures, samples);
}

}  // namespace tubeplan::planner
