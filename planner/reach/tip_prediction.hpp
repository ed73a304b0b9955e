// Tip predictions of a workcell's model for many postures, identical to predictTip() and lateralDeviation().
#pragma once

#include <cmath>

#include "deflection/kinematics.hpp"
#include "planner/reach/compensation.hpp"

namespace tubeplan::planner {

/// Returns the larger of two values; NaN if one of them is NaN.
inline double worseOf(double a, double b) { return a <= b || std::isnan(b) ? b : a; }

/// Predicts tip positions of one workcell. Each thread needs its own object. Results are NaN if a shape does not
/// converge.
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
