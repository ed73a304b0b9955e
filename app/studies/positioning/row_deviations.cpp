#include "app/studies/positioning/row_deviations.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/random_stream.hpp"
#include "deflection/rotation.hpp"
#include "deflection/tip_derivatives.hpp"
#include "planner/scene/shape.hpp"

namespace tubeplan::app {

namespace {

using Eigen::Index, Eigen::Matrix3d, Eigen::Matrix3Xd, Eigen::MatrixXd, Eigen::Vector3d;

constexpr int kPostures = 256;
constexpr std::uint64_t kSeed = 1;

std::vector<Eigen::VectorXd> drawPostures(const deflection::Arm& arm) {
  calibration::RandomStream random(kSeed);
  std::vector<Eigen::VectorXd> postures(kPostures, Eigen::VectorXd(arm.jointCount()));
  for (auto& q : postures)
    for (Index k = 0; k < q.size(); ++k) {
      const auto& joint = arm.joint(static_cast<int>(k));
      q[k] = random.uniform(std::max(joint.lower, -std::numbers::pi), std::min(joint.upper, std::numbers::pi));
    }
  return postures;
}

/// Returns the points of a row at which the deviation is evaluated, in the row's frame [m]: the ends of its bodies, and
/// the tip.
std::vector<Vector3d> pointsOn(const planner::Workcell& model, int row) {
  std::vector<Vector3d> points;
  for (const planner::Body& body : model.scene.bodies) {
    if (body.frame_index != row) continue;
    const planner::Capsule around = static_cast<const planner::Solid&>(*body.shape).around();
    points.push_back(around.from);
    points.push_back(around.to);
  }
  if (row == planner::tipRow(model.arm)) points.push_back(model.arm.p_LT);
  return points;
}

/// Jacobians and covariance that are the same for all points.
class Deviation {
 public:
  Deviation(const planner::Workcell& model, const calibration::JointUncertainty& uncertainty)
      : model_(model), covariance_(uncertainty.covariance), gravity_B_(gravityInBase(model.arm, model.X_WB)) {
    for (const auto& number : uncertainty.numbers) {
      variables_.push_back(deflection::Variable::number(number.path));
      slopes_.push_back(slopeAt(number, 0));
    }
  }

  /// Returns the largest deviation of the points of a row in a posture [m]; zero if the shape does not converge.
  [[nodiscard]] double at(const Eigen::VectorXd& q, int row, const std::vector<Vector3d>& points_L) const {
    const auto frame = deflection::differentiateRow(model_.arm, row, {q, model_.load, gravity_B_}, variables_);
    if (frame.kinematics.status != deflection::KinematicsStatus::kConverged) return 0;
    const auto& X_BL = frame.kinematics.rows[static_cast<std::size_t>(row)].X_BL;
    double largest = 0;
    for (const Vector3d& p_L : points_L) largest = std::max(largest, beyondBase(frame, X_BL, p_L));
    return largest;
  }

 private:
  [[nodiscard]] double beyondBase(const deflection::TipDerivatives& frame, const deflection::PoseOf<double>& X_BL,
                                  const Vector3d& p_L) const {
    const Vector3d r_B = X_BL.R * p_L, r_W = model_.X_WB.linear() * (X_BL.p + r_B);
    MatrixXd J(3, 6 + static_cast<Index>(slopes_.size()));
    J << Matrix3d::Identity(), -deflection::crossMatrix(r_W),
        model_.X_WB.linear() * (frame.position_B - deflection::crossMatrix(r_B) * frame.rotation_B);
    for (std::size_t k = 0; k < slopes_.size(); ++k) J.col(6 + static_cast<Index>(k)) *= slopes_[k];
    const Matrix3d together = J * covariance_ * J.transpose();
    const Matrix3d base = J.leftCols<6>() * covariance_.topLeftCorner<6, 6>() * J.leftCols<6>().transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix3d> beyond(together - base, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0., beyond.eigenvalues().maxCoeff()));
  }

  const planner::Workcell& model_;
  const MatrixXd& covariance_;
  Vector3d gravity_B_;
  std::vector<deflection::Variable> variables_;
  std::vector<double> slopes_;
};

}  // namespace

std::vector<double> rowDeviations(const planner::Workcell& model, const calibration::JointUncertainty& uncertainty) {
  if (uncertainty.numbers.empty()) return {};
  const Deviation deviation(model, uncertainty);
  const auto postures = drawPostures(model.arm);
  std::vector<double> deviations(model.arm.rows.size(), 0);
  for (int row = 0; row <= planner::tipRow(model.arm); ++row) {
    const auto points = pointsOn(model, row);
    if (points.empty()) continue;
    std::vector<double> found(postures.size());
    oneapi::tbb::parallel_for(std::size_t{0}, postures.size(),
                              [&](std::size_t k) { found[k] = deviation.at(postures[k], row, points); });
    const Eigen::Map<const Eigen::VectorXd> all(found.data(), kPostures);
    deviations[static_cast<std::size_t>(row)] = std::sqrt(all.squaredNorm() / kPostures);
  }
  return deviations;
}

}  // namespace tubeplan::app
