// The three compensation modes side by side, tube by tube, against the true arm.
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
/// Keys of the modes in documents.
inline constexpr std::array<const char*, kCompensations.size()> kModeKeys{"none", "goal_point", "via_point"};

/// The models that the modes plan with, and the truth.
struct ScoringModels {
  planner::Workcell flexible;  ///< base as calibrated by the flexible model
  planner::Workcell rigid;     ///< rigid arm, with its base as calibrated by the rigid model
  planner::Workcell truth;
};

/// Returns the models with each arm's base by its own calibration, if there was one; else both with the base of the
/// model.
[[nodiscard]] ScoringModels scoringModels(const planner::Workcell& model, const std::optional<BothCalibrations>& bases,
                                          const planner::Workcell& truth);

/// A tube and the posture whose branch is to be scored.
struct TubeToScore {
  int tube = -1;
  Eigen::VectorXd q;
  Eigen::Vector3d tip_error_W = Eigen::Vector3d::Zero();  ///< error of the true arm beyond its own model [m]
};

/// Centring by mode, in the order of kCompensations; empty if that mode finds no posture in the branch.
using ModeScores = std::array<std::optional<planner::Centring>, kCompensations.size()>;

/// A model of the arm and its assumed base.
struct PlacedModel {
  const deflection::Arm& arm;
  const Eigen::Isometry3d& X_WB;
};

/// A hole, a posture near it, and the error of the true arm there beyond its own model.
struct HoleToScore {
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();
  Eigen::VectorXd q_start;
  Eigen::Vector3d tip_error_W = Eigen::Vector3d::Zero();  ///< [m]
};

/// Returns the centring of the true arm when a model sends it to each hole's centre; empty if the model finds no
/// posture. `true_tips` belongs to the truth. The approach to the holes is not included.
[[nodiscard]] std::vector<std::optional<planner::Centring>> centringsAt(const PlacedModel& model,
                                                                        const planner::Workcell& truth,
                                                                        planner::TipPrediction& true_tips,
                                                                        const std::vector<HoleToScore>& holes);

/// Scores a tube in all modes. Without approach only the centring at the hole is scored.
[[nodiscard]] ModeScores scoreModes(const ScoringModels& models, const TubeToScore& tube, bool with_approach = true);

/// Returns the counts of 0, 1, ... steps by mode.
[[nodiscard]] std::array<std::vector<int>, kCompensations.size()> countByMode(const std::vector<ModeScores>& scores,
                                                                              int steps);

}  // namespace tubeplan::app
