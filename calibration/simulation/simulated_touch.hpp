// Simulated touches of a true arm: the tip centred in a hole within the centring noise, and the joints read with
// encoder noise.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "deflection/inverse/inverse_kinematics.hpp"

namespace tubeplan::calibration {

/// A hole to touch and a start posture, which decides the branch.
struct TouchPlan {
  std::string id, hole;
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();
  Eigen::VectorXd q_start;
};

struct TouchSimulationOptions {
  double sigma = 1.27e-4;        ///< noise of each coordinate of the centring [m] (0.005 in)
  double model_error_sigma = 0;  ///< error of the true arm beyond its own model, per coordinate [m]
  double load = 0;               ///< [N]
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();  ///< the holes' axis
  std::uint64_t seed = 1;
};

enum class TouchSimulationStatus { kNotRun, kDone, kOutOfReach };

struct TouchSimulation {
  TouchSimulationStatus status = TouchSimulationStatus::kNotRun;
  std::string reason;
  std::vector<Measurement> touches;  ///< touches of known places
};

/// Returns how the arm, standing at X_WB, brings its deflected tip to each of these places, each from a start near it.
[[nodiscard]] std::vector<deflection::Branch> reachPlaces(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                                          const std::vector<Eigen::Vector3d>& places_W,
                                                          const std::vector<Eigen::VectorXd>& starts, double load,
                                                          const Eigen::Vector3d& axis_W);

/// Returns the reading of a planned touch: joints [rad, m], load [N], centring noise of each coordinate [m].
[[nodiscard]] Measurement plannedTouch(const TouchPlan& plan, const Eigen::VectorXd& q, double load, double sigma);

/// Returns what the arm `truth`, standing at X_WB, would read at each planned touch.
[[nodiscard]] TouchSimulation simulateTouches(const deflection::Arm& truth, const Eigen::Isometry3d& X_WB,
                                              const std::vector<TouchPlan>& plans,
                                              const TouchSimulationOptions& options = {});

}  // namespace tubeplan::calibration
