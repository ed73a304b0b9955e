// The whitened residual of readings at successive states, as a fit evaluates them. Parts that do not depend on the
// variables are computed once. At an unchanged state, only the weights are applied again.
#pragma once

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/measurements/reading_prediction.hpp"
#include "deflection/kinematics.hpp"

namespace tubeplan::calibration {

/// Returns the index in `placed.base_poses` of each reading's base pose.
[[nodiscard]] std::vector<int> basePosesOf(const PlacedArm& placed, const std::vector<Measurement>& readings);

class CampaignResidual {
 public:
  /// Selects whether the residuals of the readings are followed by those of the priors, one per unknown.
  enum class Priors { kNone, kAppended };

  /// All arguments must outlive this object. An evaluation during which a stop is requested throws WorkStopped.
  CampaignResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                   const std::vector<Measurement>& readings, const ReadingWeights& weights,
                   Priors priors = Priors::kNone, StopQuestion stop = {});
  CampaignResidual(const CampaignResidual&) = delete;
  CampaignResidual& operator=(const CampaignResidual&) = delete;

  /// Computes the residual at the variables x, and its Jacobian if `jacobian` is not null. Returns false if the model
  /// cannot be evaluated.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
    return evaluate(x, r, jacobian, nullptr);
  }

  /// Also computes the unwhitened error in metres (WhitenedResidual::error), if `error` is not null.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian, Eigen::VectorXd* error);

 private:
  /// Errors in metres and their Jacobian at one state, without weights; the Jacobian is empty if not requested.
  struct Unweighted {
    Eigen::VectorXd x;
    Eigen::VectorXd error;
    Eigen::MatrixXd jacobian;
    bool ok = false;
  };

  void moveTo(const Eigen::VectorXd& x);
  bool linearize(const Eigen::VectorXd& x, bool with_jacobian);
  void applyWeights(Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) const;
  bool fill(bool with_jacobian);
  void scatter(int base_pose, const Prediction& prediction, Eigen::Index row);

  /// Returns the readings, with touched surfaces fitted to the arm at the last variables.
  [[nodiscard]] const std::vector<Measurement>& taken() const { return settled_.empty() ? readings_ : settled_; }

  const PlacedArm& start_;
  const std::vector<Unknown>& unknowns_;
  const std::vector<Measurement>& readings_;
  const ReadingWeights& weights_;
  Eigen::VectorXd prior_slopes_;  ///< derivatives of the priors' residuals; empty if no priors are appended
  StopQuestion stop_;
  std::vector<Measurement> settled_;   ///< readings with fitted surfaces; empty if no surface is touched
  std::vector<int> base_pose_of_;      ///< index of each reading's base pose
  PredictionRequest slopes_asked_;     ///< requested derivatives: the parameters, and the base if one is free
  std::vector<Eigen::Index> numbers_;  ///< Jacobian column of each parameter
  std::vector<std::vector<Eigen::Index>> bases_;  ///< Jacobian columns of a base step, -1 if fixed; empty: known base
  PlacedArm placed_;                              ///< placed arm at the last variables
  std::vector<double> slopes_;                    ///< derivative of each parameter with respect to its variable
  /// Matrices that map the rate of the rotation vector to the angular velocity, one per base.
  std::vector<Eigen::Matrix3d> turns_;
  std::optional<deflection::Kinematics> prepared_;  ///< kinematics of the arm, if no variable changes the arm
  Unweighted last_;
};

}  // namespace tubeplan::calibration
