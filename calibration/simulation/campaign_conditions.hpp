// What a simulated reading is taken under: when, under which conditions, in which sense each joint
// arrived, and with what noise.
#pragma once

#include "calibration/measurement.hpp"
#include "calibration/simulation/campaign_design.hpp"
#include "calibration/simulation/campaign_random.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

struct CampaignPace {
  double shortest = 60, longest = 180;  ///< s between two readings
  double longest_period = 28800;        ///< s, of the conditions' swings; a campaign sees half a period at least
  double overshoot = 0.5;               ///< how often a joint passes its goal and comes back
};

/// Those of one reading, drawn before its posture is known.
struct ReadingConditions {
  deflection::ConditionValues stated;  ///< time: since the campaign began
  std::vector<int> turns;              ///< of each joint: +1 it stops where it arrives, -1 it passes and comes back
  std::vector<int> rests;  ///< of each joint, the sense in which one that need not move comes back to its place
  Eigen::Vector3d coordinate_noise = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d turn_noise = Eigen::Vector3d::Zero();        ///< rad
  Eigen::VectorXd encoder_noise;                               ///< rad or m
  Eigen::VectorXd side_q;                                      ///< where the side chains' joints stand, rad or m
  Eigen::Vector3d push = Eigen::Vector3d::Zero();              ///< N, on the tip, in the world's axes

  /// The sense of each joint's last motion on the way from one posture to another.
  [[nodiscard]] std::vector<int> approach_directions(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const;
};

/// A series of conditions, in order of time.
class ConditionSeries {
 public:
  ConditionSeries(const deflection::Arm& arm, const CampaignPace& pace, int readings, const CampaignDesign& design,
                  std::uint64_t seed);

  [[nodiscard]] ReadingConditions next();

 private:
  void drawConditions(deflection::ConditionValues& stated);

  CampaignPace pace_;
  Eigen::Matrix3d noise_factor_;
  double turn_sigma_, push_, period_, time_ = 0;
  deflection::ConditionValues usual_, phases_;
  std::vector<double> encoder_sigmas_;
  std::vector<std::pair<double, double>> side_limits_;
  bool is_first_ = true;
  CampaignRandom conditions_, noise_, pushes_, side_chains_;
};

}  // namespace tubeplan::calibration
