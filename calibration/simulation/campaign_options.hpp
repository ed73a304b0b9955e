// What a simulated campaign is made among: how many readings, at which pace, at which holes and beside what.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "calibration/simulation/campaign_conditions.hpp"
#include "calibration/simulation/campaign_postures.hpp"

namespace tubeplan::calibration {

/// Whether the true arm is free of its surroundings in that set-up (from 0) under `load` [N].
using CampaignClearance = std::function<bool(int setup, double load, const Eigen::VectorXd& q)>;

struct CampaignOptions {
  int readings = 120;
  std::uint64_t seed = 1;
  CampaignPace pace;
  std::vector<CampaignPoint> holes;                        ///< m, of the sheet, for designs at holes
  Eigen::Vector3d hole_axis_W = Eigen::Vector3d::UnitZ();  ///< the way into a hole
  double standoff = 0.0254;    ///< m below a hole that is looked at and not touched, against the axis
  double least_reach = 0.2;    ///< share of the arm's reach that the tip keeps from the base's origin, without a region
  int max_draws = 2000;        ///< postures tried for one point
  CampaignClearance is_clear;  ///< empty: nothing is in the way
};

}  // namespace tubeplan::calibration
