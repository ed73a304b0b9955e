// A second proof of a written plan: from the plan's own numbers and the model, by other code than made it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

/// A tube as a plan file states it [m, rad].
struct StatedTube {
  int row = 0, column = 0;
  Eigen::Vector3d hole_W = Eigen::Vector3d::Zero();
  Eigen::VectorXd q;
  Eigen::Vector3d predicted_tip_W = Eigen::Vector3d::Zero();
  double dwell = 0;                           ///< [s]
  int zone = 0;                               ///< never decreases along the path
  std::optional<double> centring_error = {};  ///< lateral [m]
  std::optional<double> tilt = {};            ///< angle between the tool and the hole's axis [rad]
};

/// A plan as read from its files.
struct StatedPlan {
  std::vector<StatedTube> tubes;
  std::vector<std::pair<int, int>> unreachable;  ///< row, column
  std::vector<PathRow> path;
  std::optional<Eigen::VectorXd> start, end;      ///< postures where the path begins and ends [rad]
  std::optional<double> travel_time, total_time;  ///< [s]
  std::optional<double> least_clearance;          ///< clearance that the arm keeps along the whole path [m]
};

struct PlanCheckOptions {
  double centring_tolerance = 2.54e-8;  ///< [m] (1e-6 in)
  double stated_tolerance = 2.54e-8;    ///< between stated and recomputed numbers [m]
  double statics_tolerance = 5.08e-5;   ///< between the tip and that by segmented_statics.hpp [m] (0.002 in)
  double tilt_tolerance = 1e-6;  ///< beyond the tilt at which the tool's first step enters, and from a stated one [rad]
  bool limits_tilt = true;       ///< true: the tool was placed within that tilt
  double joint_tolerance = 1e-9;  ///< between a tube's joints and the end of its approach [rad]
  /// Distance of the tip from the hole's axis during the approach; only with via_points [m] (0.0011 in).
  double approach_tolerance = 2.8e-5;
  bool via_points = true;            ///< true: the approach was compensated at every via point
  double padding = 0;                ///< standard deviations of the base's place, beyond the scene's clearance
  double least_travel = 1e-4;        ///< finest step of the clearance proof [m]
  double distance_accuracy = 1e-5;   ///< accuracy of each posture's margin [m]
  double distance_share = 0.05;      ///< alternative accuracy as a share of the margin; the larger of both applies
  double report_accuracy = 2.54e-4;  ///< accuracy of the reported least margin [m] (0.010 in)
};

enum class PlanCheckStatus { kNotRun, kProved, kRefuted };

struct PlanCheck {
  PlanCheckStatus status = PlanCheckStatus::kNotRun;
  std::vector<std::string> findings;  ///< faults found, at most 100
  int tubes = 0, rows = 0;
  double worst_centring = 0;                                        ///< [m]
  double worst_approach = 0;                                        ///< [m]
  double worst_tilt = 0;                                            ///< [rad]
  double worst_statics = std::numeric_limits<double>::quiet_NaN();  ///< between the tips of both methods at tubes [m]
  std::string statics_not_covered;  ///< reason why the second method does not apply to this arm; empty if it does
  /// Reason why the deflection's part of the travel between rows is sampled; empty if it is proved.
  std::string deflection_travel_sampled;
  double worst_speed_share = 0;  ///< share of the limit
  double worst_acceleration_share = 0;
  /// Clearance of the tool in a tube; infinite if none enters [m].
  double least_play = std::numeric_limits<double>::infinity();
  double least_margin = std::numeric_limits<double>::infinity();  ///< least margin, proved between rows [m]
  std::string tightest;
};

/// Checks tubes, centring, tilts, stated times and clearance, order, joint limits, speeds, accelerations, approaches
/// and retreats along the holes' axes, and clearance of the deflected arm at the path's rows and everywhere between
/// them.
[[nodiscard]] PlanCheck checkPlan(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options = {},
                                  const PlanHooks& hooks = {});

}  // namespace tubeplan::planner
