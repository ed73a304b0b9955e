// Proves a written plan again: by the plan's own numbers and the model, with other code than made it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

/// A tube as a plan file states it. [m, rad]
struct StatedTube {
  int row = 0, column = 0;
  Eigen::Vector3d hole_W = Eigen::Vector3d::Zero();
  Eigen::VectorXd q;
  Eigen::Vector3d predicted_tip_W = Eigen::Vector3d::Zero();
  double dwell = 0;                           ///< s
  int zone = 0;                               ///< never falls along the path
  std::optional<double> centring_error = {};  ///< m, sideways
  std::optional<double> tilt = {};            ///< rad, of the tool against the hole's axis
};

/// A plan as read from its files.
struct StatedPlan {
  std::vector<StatedTube> tubes;
  std::vector<std::pair<int, int>> unreachable;  ///< row, column
  std::vector<PathRow> path;
  std::optional<Eigen::VectorXd> start, end;      ///< postures that the path sets out from and comes to rest in [rad]
  std::optional<double> travel_time, total_time;  ///< s
  std::optional<double> least_clearance;          ///< m, that the arm keeps all along
};

struct PlanCheckOptions {
  double centring_tolerance = 2.54e-8;  ///< m (1e-6 in)
  double stated_tolerance = 2.54e-8;    ///< m, between stated numbers and those found again
  double statics_tolerance = 5.08e-5;   ///< m (0.002 in), between the tip and that by segmented_statics.hpp
  double tilt_tolerance = 1e-6;   ///< rad, beyond the tilt at which the tool's first step enters, and of a stated one
  bool limits_tilt = true;        ///< the tool was placed within that tilt
  double joint_tolerance = 1e-9;  ///< rad, between a tube's joints and the end of its approach
  double approach_tolerance =
      2.8e-5;              ///< m, tip off the hole's axis while inside the approach (0.0011 in); only where via_points
  bool via_points = true;  ///< the approach was compensated at every via point
  double padding = 0;      ///< standard deviations of the base's place, beyond the scene's clearance
  double least_travel = 1e-4;        ///< m, finest step of the clearance proof
  double distance_accuracy = 1e-5;   ///< m, of each posture's margin, or ...
  double distance_share = 0.05;      ///< ... this share of the margin, where that is more
  double report_accuracy = 2.54e-4;  ///< m, of the least margin that is reported (0.010 in)
};

enum class PlanCheckStatus { kNotRun, kProved, kRefuted };

struct PlanCheck {
  PlanCheckStatus status = PlanCheckStatus::kNotRun;
  std::vector<std::string> findings;  ///< what is wrong, at most 100
  int tubes = 0, rows = 0;
  double worst_centring = 0;                                        ///< m
  double worst_approach = 0;                                        ///< m
  double worst_tilt = 0;                                            ///< rad
  double worst_statics = std::numeric_limits<double>::quiet_NaN();  ///< m, between the tips of both methods at tubes
  std::string statics_not_covered;  ///< why the second method says nothing of this arm; empty where it does
  /// Why the share of the travel between rows that is deflection's is sampled; empty where it is proved.
  std::string deflection_travel_sampled;
  double worst_speed_share = 0;  ///< of the limit
  double worst_acceleration_share = 0;
  double least_play = std::numeric_limits<double>::infinity();  ///< m, of what is in a tube; infinite where nothing is
  double least_margin = std::numeric_limits<double>::infinity();  ///< m, proved between rows
  std::string tightest;
};

/// Checks tubes, centring, tilts, stated times and clearance, order, joint limits, speeds, accelerations, approaches
/// and retreats along the holes' axes, and clearance of the deflected arm at the path's rows and everywhere between
/// them.
[[nodiscard]] PlanCheck checkPlan(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options = {},
                                  const PlanHooks& hooks = {});

}  // namespace tubeplan::planner
