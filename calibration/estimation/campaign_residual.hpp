// The whitened residual of readings at one state after another, as a fit asks for it: what no variable changes is
// worked out once, and at the state asked for last only the weights are applied anew.
#pragma once

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/measurements/reading_prediction.hpp"
#include "deflection/kinematics.hpp"

namespace tubeplan::calibration {

/// Index of the base pose that each reading was made at.
[[nodiscard]] std::vector<int> basePosesOf(const PlacedArm& placed, const std::vector<Measurement>& readings);

class CampaignResidual {
 public:
  /// Whether the unknowns' priors stand as further residuals below those of the readings, one for each unknown.
  enum class Priors { kNone, kAppended };

  /// All of these must outlive this. Asked to stop, an evaluation unwinds by WorkStopped.
  CampaignResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                   const std::vector<Measurement>& readings, const ReadingWeights& weights,
                   Priors priors = Priors::kNone, StopQuestion stop = {});
  CampaignResidual(const CampaignResidual&) = delete;
  CampaignResidual& operator=(const CampaignResidual&) = delete;

  /// The residual at variables x, its Jacobian where it is not null; false where the model cannot be evaluated.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
    return evaluate(x, r, jacobian, nullptr);
  }

  /// The same with the error in metres, not whitened (WhitenedResidual::error), where it is not null.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian, Eigen::VectorXd* error);

 private:
  /// Errors in metres and their slopes at one state, by no weights; no slopes where they were not asked for.
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

  /// The readings, those of surfaces with the surface as the arm at the variables asked for last touches it.
  [[nodiscard]] const std::vector<Measurement>& taken() const { return settled_.empty() ? readings_ : settled_; }

  const PlacedArm& start_;
  const std::vector<Unknown>& unknowns_;
  const std::vector<Measurement>& readings_;
  const ReadingWeights& weights_;
  Eigen::VectorXd prior_slopes_;  ///< none where no priors are appended
  StopQuestion stop_;
  std::vector<Measurement> settled_;                ///< none where no surface is touched
  std::vector<int> base_pose_of_;                   ///< of each reading
  PredictionRequest slopes_asked_;                  ///< the numbers, and the base where one is free
  std::vector<Eigen::Index> numbers_;               ///< column of each number
  std::vector<std::vector<Eigen::Index>> bases_;    ///< of each placing: six columns, or none
  PlacedArm placed_;                                ///< at the variables asked for last, with ...
  std::vector<double> slopes_;                      ///< ... the slope of each number by its variable ...
  std::vector<Eigen::Matrix3d> turns_;              ///< ... and from the rotation vector's rate to the turn's
  std::optional<deflection::Kinematics> prepared_;  ///< of the placed arm, where no variable changes that
  Unweighted last_;
};

}  // namespace tubeplan::calibration
