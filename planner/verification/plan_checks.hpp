// A second proof of a written plan. It uses only the values in the plan's files and the model, and different code from
// the planner's.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

/// A tube as stated in a plan file [m, rad].
struct StatedTube {
  int row = 0, column = 0;
  Eigen::Vector3d hole_W = Eigen::Vector3d::Zero();
  Eigen::VectorXd q;
  Eigen::Vector3d predicted_tip_W = Eigen::Vector3d::Zero();
  double dwell = 0;                           ///< dwell time at the hole [s]
  int zone = 0;                               ///< number of the tube's zone; never decreases along the path
  std::optional<double> centring_error = {};  ///< lateral distance of the tip from the hole's axis [m]
  std::optional<double> tilt = {};            ///< angle between the tool axis and the hole's axis [rad]
};

/// A plan as read from its files.
struct StatedPlan {
  std::vector<StatedTube> tubes;
  std::vector<std::pair<int, int>> unreachable;  ///< row and column of each tube that is stated as unreachable
  std::vector<PathRow> path;
  std::optional<Eigen::VectorXd> start, end;      ///< postures where the path begins and ends [rad]
  std::optional<double> travel_time, total_time;  ///< stated times of all travels and of the whole path [s]
  std::optional<double> least_clearance;          ///< stated smallest clearance along the whole path [m]
};

struct PlanCheckOptions {
  double centring_tolerance = 2.54e-8;  ///< largest distance of the tip from its goal at a tube [m] (1e-6 in)
  double stated_tolerance = 2.54e-8;    ///< largest difference between stated and recomputed values [m]
  /// Largest distance between the model's tip and the tip computed by segmented_statics.hpp [m] (0.002 in).
  double statics_tolerance = 5.08e-5;
  /// Tolerance [rad]: by how much the tilt may exceed the largest tilt at which the tool's first step still enters, and
  /// by how much it may differ from a stated tilt.
  double tilt_tolerance = 1e-6;
  bool limits_tilt = true;  ///< if true, the tilt must be small enough for the tool's first step to enter
  /// Largest difference of a joint value between a tube and the end of its approach [rad].
  double joint_tolerance = 1e-9;
  /// Largest distance of the tip from the hole's axis during the approach [m] (0.0011 in); applies only with
  /// via_points.
  double approach_tolerance = 2.8e-5;
  bool via_points = true;  ///< true if the approach was compensated at every via point
  /// Number of standard deviations of the base's pose by which the scene's clearance is increased.
  double padding = 0;
  double least_travel = 1e-4;        ///< travel below which the clearance proof does not bisect a segment [m]
  double distance_accuracy = 1e-5;   ///< accuracy of each posture's margin [m]
  double distance_share = 0.05;      ///< alternative accuracy, as a fraction of the margin; the larger one applies
  double report_accuracy = 2.54e-4;  ///< accuracy of the reported smallest margin [m] (0.010 in)
};

enum class PlanCheckStatus { kNotRun, kProved, kRefuted };

struct PlanCheck {
  PlanCheckStatus status = PlanCheckStatus::kNotRun;
  std::vector<std::string> findings;  ///< faults found, at most 100
  int tubes = 0, rows = 0;
  double worst_centring = 0;  ///< largest distance of the tip from its goal at a tube [m]
  double worst_approach = 0;  ///< largest distance of the tip from the hole's axis during approaches and retreats [m]
  double worst_tilt = 0;      ///< largest angle between the tool axis and the hole's axis [rad]
  /// Largest distance between the tip positions that the two methods compute for a tube [m].
  double worst_statics = std::numeric_limits<double>::quiet_NaN();
  std::string statics_not_covered;  ///< reason why the second method does not apply to this arm; empty if it does
  /// Reason why the bound on travel by deflection is sampled, not proved; empty if it is proved.
  std::string deflection_travel_sampled;
  double worst_speed_share = 0;  ///< largest joint speed as a fraction of its limit
  double worst_acceleration_share = 0;
  /// Smallest clearance of the tool in a tube [m]; infinite if the tool enters no tube.
  double least_play = std::numeric_limits<double>::infinity();
  /// Smallest margin along the path, at its rows and between them [m].
  double least_margin = std::numeric_limits<double>::infinity();
  std::string tightest;
};

/// Checks the tubes, centring, tilts, stated times and stated clearance, the order, joint limits, speeds and
/// accelerations, and approaches and retreats along the holes' axes. Also checks the clearance of the deflected arm at
/// the path's rows and everywhere between them.
[[nodiscard]] PlanCheck checkPlan(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options = {},
                                  const PlanHooks& hooks = {});

}  // namespace tubeplan::planner
