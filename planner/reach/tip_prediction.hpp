// Predicted tips of a workcell's model for many postures, with the results of predictTip() and lateralDeviation().
#pragma once

#include <cmath>

#include "deflection/kinematics.hpp"
#include "planner/reach/compensation.hpp"

namespace tubeplan::planner {

/// Returns the larger of two numbers; NaN if either is NaN.
inline double worseOf(double a, double b) { return a <= b || std::isnan(b) ? b : a; }

/// Predictor of tips of one workcell; each thread needs its own. Results are NaN if a shape does not converge.
class TipPrediction {
 public:
  /// `cell` must outlive this object, and must not change.
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
