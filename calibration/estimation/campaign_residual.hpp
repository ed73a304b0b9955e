// Whitened residual of measurements for repeated evaluation in a fit. Parts that do not depend on the variables are
// computed once. If only the weights have changed since the last evaluation, the model is not evaluated again.
#pragma once

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/kinematics.hpp"

namespace tubeplan::calibration {

/// Returns, for each measurement, the index of its base pose in `placed.base_poses`.
[[nodiscard]] std::vector<int> basePosesOf(const PlacedArm& placed, const std::vector<Measurement>& measurements);

class CampaignResidual {
 public:
  /// Content of the residual vector: only the measurements' rows, or also the priors' residuals after them, one per
  /// unknown.
  enum class Priors { kNone, kAppended };

  /// Arguments passed by reference must outlive this object. An evaluation throws WorkStopped if a stop is requested.
  CampaignResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                   const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
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
  /// Errors before weighting [m] and their Jacobian at the variables `x`; the Jacobian is empty if it was not
  /// requested.
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

  /// Returns the measurements, with touched surfaces fitted to the arm at the last variables.
  [[nodiscard]] const std::vector<Measurement>& taken() const { return settled_.empty() ? measurements_ : settled_; }

  const PlacedArm& start_;
  const std::vector<Unknown>& unknowns_;
  const std::vector<Measurement>& measurements_;
  const MeasurementWeights& weights_;
  /// Derivatives of the prior residuals with respect to the variables; empty if no priors are appended.
  Eigen::VectorXd prior_slopes_;
  StopQuestion stop_;
  /// Measurements with their touched surfaces as fitted; empty if no measurement touches a surface.
  std::vector<Measurement> settled_;
  std::vector<int> base_pose_of_;  ///< index of each measurement's base pose
  PredictionRequest
      requested_slopes_;  ///< derivatives to compute: by the free parameters, and by the base if one is free
  std::vector<Eigen::Index> numbers_;  ///< Jacobian column of each parameter
  /// For each base, Jacobian columns of its step, -1 for a fixed component; empty means known base.
  std::vector<std::vector<Eigen::Index>> bases_;
  PlacedArm placed_;            ///< placed arm at the variables of the last evaluation
  std::vector<double> slopes_;  ///< derivative of each parameter with respect to its variable
  /// Matrices that map the rate of the rotation vector to the angular velocity, one per base.
  std::vector<Eigen::Matrix3d> turns_;
  std::optional<deflection::Kinematics> prepared_;  ///< kinematics of the arm, if no variable changes the arm
  Unweighted last_;
};

}  // namespace tubeplan::calibration
