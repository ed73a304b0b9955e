#include "calibration/measurement_checks/quick_alignment.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "calibration/measurements/measurement_posture.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::calibration {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

constexpr double kBlindShare = 0.01;  // of the reach: what a rigid drawing may be off by
constexpr int kReweighings = 4;
constexpr std::size_t kLeastPlaces = 6;

/// Tips and the places measured of them, of one set-up.
struct Cloud {
  std::vector<Vector3d> tips, places;
};

/// Squares of the distances between places and tips placed by X.
void squaresOf(const Cloud& cloud, const Matrix3d& R, const Vector3d& p, std::vector<double>& squares) {
  squares.resize(cloud.tips.size());
  for (std::size_t k = 0; k < squares.size(); ++k)
    squares[k] = (R * cloud.tips[k] + p - cloud.places[k]).squaredNorm();
}

/// Squares of the errors after the placing that leaves least, by weights that fall with the error (Horn 1987 by the
/// singular values of Arun, Huang and Blostein; weights of Cauchy).
void align(const Cloud& cloud, double blind, std::vector<double>& squares) {
  std::vector<double> weights(cloud.tips.size(), 1);
  for (int repeat = 0; repeat < kReweighings; ++repeat) {
    double sum = 0;
    Vector3d tip = Vector3d::Zero(), place = Vector3d::Zero();
    for (std::size_t k = 0; k < weights.size(); ++k) {
      tip += weights[k] * cloud.tips[k], place += weights[k] * cloud.places[k];
      sum += weights[k];
    }
    tip /= sum, place /= sum;
    Matrix3d H = Matrix3d::Zero();
    for (std::size_t k = 0; k < weights.size(); ++k)
      H += weights[k] * (cloud.places[k] - place) * (cloud.tips[k] - tip).transpose();
    const Eigen::JacobiSVD<Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1 : 1;
    const Matrix3d R = svd.matrixU() * Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
    squaresOf(cloud, R, place - R * tip, squares);
    double typical = 0;
    for (const double square : squares) typical += std::log(square + blind * blind);
    typical = std::exp(typical / static_cast<double>(squares.size()));
    for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = 1 / (1 + squares[k] / typical);
  }
}

}  // namespace

QuickAlignment::QuickAlignment(const PlacedArm& start, double reach)
    : rigid_{deflection::rigidCopy(start.arm), start.base_poses}, blind_(kBlindShare * reach) {}

std::vector<Vector3d> QuickAlignment::tips(const std::vector<Measurement>& readings) const {
  deflection::PreparedArm arm(rigid_.arm);
  std::vector<Vector3d> tips(readings.size(), Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const Measurement& reading = readings[k];
    if (!statesPlace(reading)) continue;
    const auto& X_WB = rigid_.base_poses[static_cast<std::size_t>(basePoseOf(rigid_, reading))].X_WB;
    if (arm.solve(postureOf(reading, rigid_.arm, X_WB)) != deflection::KinematicsStatus::kConverged) continue;
    tips[k] = arm.X_BD().p;
    if (reading.p_TQ) tips[k] += arm.X_BD().R * *reading.p_TQ;
  }
  return tips;
}

double QuickAlignment::score(const std::vector<Measurement>& readings, const std::vector<Vector3d>& tips,
                             bool frees_base, double share) const {
  const double blind = share * blind_;
  double sum = 0;
  std::size_t count = 0;
  std::vector<double> squares;
  for (std::size_t p = 0; p < rigid_.base_poses.size(); ++p) {
    const BasePose& base_pose = rigid_.base_poses[p];
    const bool is_known = base_pose.is_known && !frees_base;
    Cloud cloud;
    for (std::size_t k = 0; k < readings.size(); ++k) {
      if (!tips[k].allFinite() || !readings[k].p_W || basePoseOf(rigid_, readings[k]) != static_cast<int>(p)) continue;
      cloud.tips.push_back(tips[k]);
      cloud.places.push_back(*readings[k].p_W);
    }
    if (cloud.tips.size() < (is_known ? 1 : kLeastPlaces)) continue;
    if (is_known)
      squaresOf(cloud, base_pose.X_WB.linear(), base_pose.X_WB.translation(), squares);
    else
      align(cloud, blind, squares);
    for (const double square : squares) sum += std::log1p(square / (blind * blind)) / 2;
    count += squares.size();
  }
  return count < kLeastPlaces ? std::numeric_limits<double>::infinity() : sum / static_cast<double>(count);
}

}  // namespace tubeplan::calibration
