// The whitened misfit of touched holes for a placing of the base, with exact derivatives.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "deflection/tip_derivatives.hpp"

namespace tubeplan::calibration {

/// A hole that a touch may have been mistaken for.
struct NeighbourHole {
  std::string name;
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();
};

/// The tip centred in a known hole. m, rad, N.
struct Touch {
  std::string id;
  std::string hole;
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();  ///< the hole's centre on the face
  Eigen::VectorXd q;                               ///< joint readings
  double load = 0;                                 ///< hung on the tip
  double sigma = 0;                                ///< of each coordinate of the centring
  std::vector<NeighbourHole> neighbours;           ///< for telling a mistaken hole
};

/// A small change of the base pose: translation of its origin [m], then a rotation vector [rad], both in world axes;
/// X_WB becomes (exp(rotation) R, p + translation). The order of every 6 x 6 covariance of a base.
using BaseStep = Eigen::Matrix<double, 6, 1>;
Eigen::Isometry3d moved(const Eigen::Isometry3d& X_WB, const BaseStep& step);

/// Tip place in the world and its derivatives by the base step, by the joints. Gravity turns in the base frame as the
/// base turns.
struct TipInWorld {
  bool ok = false;  ///< whether the deflected shape settled; the rest is NaN otherwise
  Eigen::Vector3d p_WT = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Matrix<double, 3, 6> by_base = Eigen::Matrix<double, 3, 6>::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Matrix3Xd by_joints;
};
[[nodiscard]] TipInWorld tipInWorld(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q,
                                    double load);

/// Covariance [m^2] of the tip's place from base covariance and encoder noise together.
Eigen::Matrix3d tipCovariance(const deflection::Arm& arm, const TipInWorld& tip,
                              const Eigen::Matrix<double, 6, 6>& base_covariance);

/// Covariance of one touch: centring noise and encoder noise through the arm's Jacobian.
Eigen::Matrix3d touchCovariance(const deflection::Arm& arm, const TipInWorld& tip, double sigma);

}  // namespace tubeplan::calibration
