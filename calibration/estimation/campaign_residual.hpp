// The whitened residual of readings at one state after another, as a fit needs it. Parts that do not depend on the
// variables are computed once, and at the last state only the weights are applied again.
#pragma once

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/measurements/reading_prediction.hpp"
#include "deflection/kinematics.hpp"

namespace tubeplan::calibration {

/// Returns the index of the base pose of each reading.
[[nodiscard]] std::vector<int> basePosesOf(const PlacedArm& placed, const std::vector<Measurement>& readings);

class CampaignResidual {
 public:
  /// Choice whether the unknowns' priors are further residuals after those of the readings, one for each unknown.
  enum class Priors { kNone, kAppended };

  /// All arguments must outlive this object. An evaluation that is asked to stop throws WorkStopped.
  CampaignResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                   const std::vector<Measurement>& readings, const ReadingWeights& weights,
                   Priors priors = Priors::kNone, StopQuestion stop = {});
  CampaignResidual(const CampaignResidual&) = delete;
  CampaignResidual& operator=(const CampaignResidual&) = delete;

  /// Computes the residual at variables x, and its Jacobian if not null. Returns false if the model cannot be
  /// evaluated.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
    return evaluate(x, r, jacobian, nullptr);
  }

  /// Computes also the error in metres, not whitened (WhitenedResidual::error), if not null.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian, Eigen::VectorXd* error);

 private:
  /// Errors in metres and their slopes at one state, without weights; no slopes if they were not asked for.
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

  /// Returns the readings; those of surfaces have the surface fitted to the arm at the last variables.
  [[nodiscard]] const std::vector<Measurement>& taken() const { return settled_.empty() ? readings_ : settled_; }

  const PlacedArm& start_;
  const std::vector<Unknown>& unknowns_;
  const std::vector<Measurement>& readings_;
  const ReadingWeights& weights_;
  Eigen::VectorXd prior_slopes_;  ///< slopes of the priors; empty if none are appended
  StopQuestion stop_;
  std::vector<Measurement> settled_;                ///< readings with fitted surfaces; empty if no surface is touched
  std::vector<int> base_pose_of_;                   ///< base pose of each reading
  PredictionRequest slopes_asked_;                  ///< the numbers, and the base if one is free
  std::vector<Eigen::Index> numbers_;               ///< column of each number
  std::vector<std::vector<Eigen::Index>> bases_;    ///< six columns of each base, or none
  PlacedArm placed_;                                ///< state at the last variables
  std::vector<double> slopes_;                      ///< slope of each number by its variable
  std::vector<Eigen::Matrix3d> turns_;              ///< matrices from the rotation vector's rate to the angular rate
  std::optional<deflection::Kinematics> prepared_;  ///< kinematics of the placed arm, if no variable changes it
  Unweighted last_;
};

}  // namespace tubeplan::calibration
