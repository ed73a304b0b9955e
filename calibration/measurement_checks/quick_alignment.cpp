#include "calibration/measurement_checks/quick_alignment.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "calibration/measurements/measurement_posture.hpp"

namespace tubeplan::calibration {

using Eigen::Matrix3d, Eigen::Matrix4d, Eigen::Vector3d;

namespace {

constexpr double kBlindShare = 0.01;  // typical error of the nominal rigid arm, as a fraction of the reach
constexpr double kRows = 3;           // number of measured coordinates of a measurement
// Usual displacement of a base: rotation [rad], and shift relative to the reach.
constexpr double kUsualTurnOfBase = 0.05, kUsualShiftOfBase = 0.05;
constexpr int kReweighings = 3;
constexpr std::size_t kLeastPlaces = 6;

/// Predicted tips in the base frame, and their measured positions in the world frame [m], of one set-up.
struct Cloud {
  std::vector<Vector3d> tips, places;
};

struct Placing {
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero();
};

void squaresOf(const Cloud& cloud, const Placing& X, std::vector<double>& squares) {
  squares.resize(cloud.tips.size());
  for (std::size_t k = 0; k < squares.size(); ++k)
    squares[k] = (X.R * cloud.tips[k] + X.p - cloud.places[k]).squaredNorm();
}

/// Returns the largest eigenvalue of the symmetric matrix K with zero trace, found with Newton's method on the
/// characteristic polynomial, starting at an upper bound.
double largestEigenvalue(const Matrix4d& K, const Matrix3d& H, double bound) {
  constexpr int kMostSteps = 30;
  const double c2 = -2 * H.squaredNorm(), c1 = -8 * H.determinant(), c0 = K.determinant();
  double value = bound;
  for (int step = 0; step < kMostSteps; ++step) {
    const double square = value * value;
    const double slope = 4 * square * value + 2 * c2 * value + c1;
    const double by = (square * square + c2 * square + c1 * value + c0) / slope;
    if (!std::isfinite(by)) break;
    value -= by;
    if (std::abs(by) < 1e-11 * bound) break;
  }
  return value;
}

/// Returns the rotation that best maps vectors a to vectors b, where H is the sum of a b^T. The method is due to Horn
/// 1987, with unit quaternions; the eigenvector is computed as in Theobald 2005 and in Liu, Agrafiotis and Theobald
/// 2010. `bound` is half the sum of the squared lengths of all a and b.
Matrix3d turnBetween(const Matrix3d& H, double bound) {
  Matrix4d K;
  K << H(0, 0) + H(1, 1) + H(2, 2), H(1, 2) - H(2, 1), H(2, 0) - H(0, 2), H(0, 1) - H(1, 0),  //
      H(1, 2) - H(2, 1), H(0, 0) - H(1, 1) - H(2, 2), H(0, 1) + H(1, 0), H(2, 0) + H(0, 2),   //
      H(2, 0) - H(0, 2), H(0, 1) + H(1, 0), H(1, 1) - H(0, 0) - H(2, 2), H(1, 2) + H(2, 1),   //
      H(0, 1) - H(1, 0), H(2, 0) + H(0, 2), H(1, 2) + H(2, 1), H(2, 2) - H(0, 0) - H(1, 1);
  const Matrix4d shifted = K - largestEigenvalue(K, H, bound) * Matrix4d::Identity();
  Eigen::Vector4d best = Eigen::Vector4d::Unit(0);
  double longest = 0;
  for (int row = 0; row < 4; ++row) {  // any nonzero row of cofactors is an eigenvector
    Eigen::Vector4d cofactors;
    for (int column = 0; column < 4; ++column) {
      Matrix3d minor;
      for (int r = 0, at = 0; r < 4; ++r) {
        if (r == row) continue;
        for (int c = 0, to = 0; c < 4; ++c)
          if (c != column) minor(at, to++) = shifted(r, c);
        ++at;
      }
      cofactors[column] = ((row + column) % 2 ? -1 : 1) * minor.determinant();
    }
    if (const double length = cofactors.norm(); length > longest) longest = length, best = cofactors / length;
  }
  return Eigen::Quaterniond(best[0], best[1], best[2], best[3]).toRotationMatrix();
}

/// Returns the pose that minimises the weighted sum of squared distances between the tips and their measured positions.
Placing aligned(const Cloud& cloud, const std::vector<double>& weights) {
  double sum = 0, squares = 0;
  Vector3d tip = Vector3d::Zero(), place = Vector3d::Zero();
  for (std::size_t k = 0; k < weights.size(); ++k) {
    tip += weights[k] * cloud.tips[k], place += weights[k] * cloud.places[k];
    sum += weights[k];
  }
  tip /= sum, place /= sum;
  Matrix3d H = Matrix3d::Zero();
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const Vector3d a = cloud.tips[k] - tip, b = cloud.places[k] - place;
    H += weights[k] * a * b.transpose();
    squares += weights[k] * (a.squaredNorm() + b.squaredNorm());
  }
  const Matrix3d R = turnBetween(H, squares / 2);
  return {R, place - R * tip};
}

/// Returns the log prior odds against a base at this distance from its nominal pose, by the same formula as in
/// mistake_trials.cpp.
double oddsAgainst(const Placing& X, const Eigen::Isometry3d& nominal, double reach) {
  const double shift = (X.p - nominal.translation()).norm() / (kUsualShiftOfBase * reach);
  const double turn = Eigen::AngleAxisd(X.R * nominal.linear().transpose()).angle() / kUsualTurnOfBase;
  return 3.5 * std::log1p(shift * shift + turn * turn);
}

/// Returns the sum of log(1 + square / blind^2) / 2 over all squares.
double sumOf(const std::vector<double>& squares, double blind) {
  double sum = 0;
  for (const double square : squares) sum += std::log1p(square / (blind * blind)) / 2;
  return sum;
}

/// Returns sumOf() after the best alignment of the base, plus the log prior odds against this base. As long as the sum
/// is below `promising`, the alignment is repeated a few times with Cauchy weights, scaled by the typical squared
/// error.
double alignedSum(const Cloud& cloud, const Eigen::Isometry3d& nominal, double blind, double promising) {
  std::vector<double> weights(cloud.tips.size(), 1), squares;
  Placing X = aligned(cloud, weights);
  squaresOf(cloud, X, squares);
  double sum = sumOf(squares, blind);
  for (int repeat = 0; repeat < kReweighings && sum < promising; ++repeat) {
    const double typical = blind * blind * std::exp(2 * sum / static_cast<double>(squares.size()));
    for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = 1 / (1 + squares[k] / typical);
    const Placing next = aligned(cloud, weights);
    squaresOf(cloud, next, squares);
    const double found = sumOf(squares, blind);
    if (!(found < sum)) break;
    sum = found, X = next;
  }
  return sum + oddsAgainst(X, nominal, blind / kBlindShare) / kRows;
}

}  // namespace

QuickAlignment::QuickAlignment(const PlacedArm& start, double reach)
    : rigid_{deflection::rigidCopy(start.arm), start.base_poses}, arm_(rigid_.arm), blind_(kBlindShare * reach) {}

std::vector<Vector3d> QuickAlignment::tips(const std::vector<Measurement>& measurements) {
  std::vector<Vector3d> tips(measurements.size(), Vector3d::Constant(kNotKnown));
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    const Measurement& measurement = measurements[k];
    if (!statesPlace(measurement)) continue;
    const auto& X_WB = basePoseAt(rigid_, measurement);
    if (arm_.solve(postureOf(measurement, rigid_.arm, X_WB)) != deflection::KinematicsStatus::kConverged) continue;
    tips[k] = arm_.X_BD().p;
    if (measurement.p_TQ) tips[k] += arm_.X_BD().R * *measurement.p_TQ;
  }
  return tips;
}

double QuickAlignment::score(const std::vector<Measurement>& measurements, const std::vector<Vector3d>& tips,
                             const QuickAlignmentOptions& options) const {
  const double blind = options.share * blind_;
  double sum = 0;
  std::size_t count = 0;
  std::vector<double> squares;
  for (std::size_t p = 0; p < rigid_.base_poses.size(); ++p) {
    const BasePose& base_pose = rigid_.base_poses[p];
    const bool is_known = base_pose.is_known && !options.frees_base;
    Cloud cloud;
    for (std::size_t k = 0; k < measurements.size(); ++k) {
      if (!tips[k].allFinite() || !measurements[k].p_W || basePoseOf(rigid_, measurements[k]) != static_cast<int>(p))
        continue;
      cloud.tips.push_back(tips[k]);
      cloud.places.push_back(*measurements[k].p_W);
    }
    const std::size_t of_this = cloud.tips.size();
    if (of_this < (is_known ? 1 : kLeastPlaces)) continue;
    if (is_known) {
      squaresOf(cloud, {base_pose.X_WB.linear(), base_pose.X_WB.translation()}, squares);
      sum += sumOf(squares, blind);
    } else {
      sum += alignedSum(cloud, base_pose.X_WB, blind, options.promising * static_cast<double>(of_this));
    }
    count += of_this;
  }
  return count < kLeastPlaces ? std::numeric_limits<double>::infinity() : sum / static_cast<double>(count);
}

}  // namespace tubeplan::calibration
