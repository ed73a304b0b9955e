// Simulated touches with a true arm: the tip is centred in a hole up to the centring noise, and the joints are read
// with encoder noise.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "deflection/inverse/inverse_kinematics.hpp"

namespace tubeplan::calibration {

/// A hole to touch, and a start posture that decides the branch of the inverse kinematics.
struct TouchPlan {
  std::string id, hole;
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();
  Eigen::VectorXd q_start;
};

struct TouchSimulationOptions {
  double sigma = 1.27e-4;        ///< standard deviation of each coordinate of the centring [m] (0.005 in)
  double model_error_sigma = 0;  ///< standard deviation per coordinate of the true arm's error beyond its own model [m]
  double load = 0;               ///< load hung from the tip [N]
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();  ///< axis of the holes, in the world frame
  std::uint64_t seed = 1;
};

enum class TouchSimulationStatus { kNotRun, kDone, kOutOfReach };

struct TouchSimulation {
  TouchSimulationStatus status = TouchSimulationStatus::kNotRun;
  std::string reason;
  std::vector<Measurement> touches;  ///< touches of points with known positions
};

/// Returns, for each of the points `places_W` [m], the inverse kinematics solution that brings the deflected tip there,
/// found from the nearby start posture of the same index. The base is at X_WB, and `axis_W` is the axis of the holes.
[[nodiscard]] std::vector<deflection::Branch> reachPlaces(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                                          const std::vector<Eigen::Vector3d>& places_W,
                                                          const std::vector<Eigen::VectorXd>& starts, double load,
                                                          const Eigen::Vector3d& axis_W);

/// Returns the measurement of a planned touch at the joint readings `q` [rad, m] under `load` [N], with the centring
/// noise `sigma` of each coordinate [m].
[[nodiscard]] Measurement plannedTouch(const TouchPlan& plan, const Eigen::VectorXd& q, double load, double sigma);

/// Simulates one touch for each plan by the arm `truth` with its base at X_WB. Fails if a hole is out of reach.
[[nodiscard]] TouchSimulation simulateTouches(const deflection::Arm& truth, const Eigen::Isometry3d& X_WB,
                                              const std::vector<TouchPlan>& plans,
                                              const TouchSimulationOptions& options = {});

}  // namespace tubeplan::calibration
