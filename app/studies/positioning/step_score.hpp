// Comparison, tube by tube, of how well the true arm is centred in each of the three compensation modes.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/studies/measurements/simulated_calibration.hpp"
#include "planner/reach/scoring.hpp"
#include "planner/reach/tip_prediction.hpp"

namespace tubeplan::app {

inline constexpr std::array kCompensations{planner::Compensation::kNone, planner::Compensation::kGoalPoint,
                                           planner::Compensation::kViaPoint};
/// Keys of the compensation modes in documents.
inline constexpr std::array<const char*, kCompensations.size()> kModeKeys{"none", "goal_point", "via_point"};

/// Models with which the compensation modes steer the arm, and the true arm.
struct ScoringModels {
  planner::Workcell flexible;  ///< flexible arm, on the base calibrated with the flexible model
  planner::Workcell rigid;     ///< rigid arm, on the base calibrated with the rigid model
  planner::Workcell truth;
};

/// Returns the models for scoring. Each arm has the base of its own calibration; without `bases`, both have the base of
/// `model`.
[[nodiscard]] ScoringModels scoringModels(const planner::Workcell& model, const std::optional<BothCalibrations>& bases,
                                          const planner::Workcell& truth);

/// A tube, and a posture that selects the branch of the postures to be scored.
struct TubeToScore {
  int tube = -1;
  Eigen::VectorXd q;
  Eigen::Vector3d tip_error_W = Eigen::Vector3d::Zero();  ///< unmodelled error of the true arm's tip [m]
};

/// Centring in each mode, in the order of kCompensations; empty for a mode that finds no posture in the branch.
using ModeScores = std::array<std::optional<planner::Centring>, kCompensations.size()>;

/// A model of the arm with its assumed base pose.
struct PlacedModel {
  const deflection::Arm& arm;
  const Eigen::Isometry3d& X_WB;
};

/// A hole, a posture near the hole, and the unmodelled error of the true arm there.
struct HoleToScore {
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();
  Eigen::VectorXd q_start;
  Eigen::Vector3d tip_error_W = Eigen::Vector3d::Zero();  ///< unmodelled error of the true arm's tip [m]
};

/// Returns the centring of the true arm at each hole when the given model steers it to the hole's centre; empty if the
/// model finds no posture. `true_tips` predicts the tip of `truth`. The approach to the holes is not included.
[[nodiscard]] std::vector<std::optional<planner::Centring>> centringsAt(const PlacedModel& model,
                                                                        const planner::Workcell& truth,
                                                                        planner::TipPrediction& true_tips,
                                                                        const std::vector<HoleToScore>& holes);

/// Returns the centring at a tube in all modes. Without `with_approach` only the hole itself is considered, not the
/// approach.
[[nodiscard]] ModeScores scoreModes(const ScoringModels& models, const TubeToScore& tube, bool with_approach = true);

/// Returns, for each mode, the number of tubes in which 0, 1, ... steps enter.
[[nodiscard]] std::array<std::vector<int>, kCompensations.size()> countByMode(const std::vector<ModeScores>& scores,
                                                                              int steps);

}  // namespace tubeplan::app
