// The tip as a workcell's model has it, for many postures: what predictTip() and lateralDeviation() answer one by one.
#pragma once

#include <cmath>

#include "deflection/kinematics.hpp"
#include "planner/reach/compensation.hpp"

namespace tubeplan::planner {

/// The larger; not a number where one is none.
inline double worseOf(double a, double b) { return a <= b || std::isnan(b) ? b : a; }

/// Predicts tips of one workcell; each thread needs its own. Not numbers where a shape does not converge.
class TipPrediction {
 public:
  /// `cell` must outlive this, and stay as it is.
  explicit TipPrediction(const Workcell& cell);

  [[nodiscard]] PredictedTip at(const Eigen::VectorXd& q);
  [[nodiscard]] double lateralDeviation(const Eigen::Vector3d& hole_W, const std::vector<Eigen::VectorXd>& postures,
                                        int samples = 4);

 private:
  const Workcell& cell_;
  Eigen::Vector3d gravity_B_;
  deflection::Kinematics kinematics_;
  deflection::PostureBatch postures_;
  deflection::TipBatch tips_;
};

}  // namespace tubeplan::planner
