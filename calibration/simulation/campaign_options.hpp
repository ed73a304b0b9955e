// Options of a simulated campaign: number of measurements, pace, holes and obstacles.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "calibration/simulation/campaign_conditions.hpp"
#include "calibration/simulation/campaign_postures.hpp"

namespace tubeplan::calibration {

/// Function that returns true if the true arm at `q` under `load` [N] is clear of all obstacles. `setup` is the index
/// of the set-up, from 0.
using CampaignClearance = std::function<bool(int setup, double load, const Eigen::VectorXd& q)>;

struct CampaignOptions {
  int measurements = 120;
  std::uint64_t seed = 1;
  CampaignPace pace;
  std::vector<CampaignPoint> holes;  ///< holes of the sheet, for designs that measure at holes [m]
  Eigen::Vector3d hole_axis_W = Eigen::Vector3d::UnitZ();  ///< direction into a hole, in the world frame
  double standoff = 0.0254;  ///< distance of the tip below a hole that is not touched, along the hole's axis [m]
  /// Smallest distance of the tip from the base's origin if the design has no region, as a fraction of the arm's reach.
  double least_reach = 0.2;
  int max_draws = 2000;        ///< largest number of postures tried for one point
  CampaignClearance is_clear;  ///< collision check; empty means that there are no obstacles
};

}  // namespace tubeplan::calibration
