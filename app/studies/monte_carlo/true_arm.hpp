// True arms drawn at random about a given arm; the true arm is unknown to the simulated experiment.
#pragma once

#include <cmath>
#include <vector>

#include "app/studies/monte_carlo/random_draw.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/parameters.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

struct TruthSpread {
  double base_shift_sigma = 0.0127;  ///< standard deviation of the base position per coordinate [m] (0.5 in)
  double base_turn_sigma = 0.0087;   ///< standard deviation of the base rotation per axis [rad] (0.5 deg)
  double stiffness_sigma = 0.02;     ///< relative standard deviation of each stiffness of the arm
  /// Error of the true arm that no model predicts, per coordinate [m], independent in each posture. If the truth equals
  /// the model, 0.0197 in leaves a mean error of 0.030 in at 14 touch points after the base is fitted, as in table 5.6
  /// of Calkins 1994; if the stiffnesses differ, the mean error is larger. Each run of `score` prints the resulting
  /// error.
  double unmodelled_sigma = 5.0e-4;
};

/// Draws true arms with random base poses and stiffnesses about a given workcell.
class TruthMaker {
 public:
  TruthMaker(planner::Workcell about, const TruthSpread& spread) : about_(std::move(about)), spread_(spread) {
    for (const auto& parameter : deflection::parametersOf(about_.arm))
      if (parameter.quantity == deflection::Quantity::kTorquePerAngle ||
          parameter.quantity == deflection::Quantity::kLengthToTheFourth)
        stiffnesses_.push_back(parameter.path);
  }

  template <class Source>
  [[nodiscard]] planner::Workcell draw(calibration::RandomStreamFrom<Source>& draw) const {
    planner::Workcell truth = about_;
    calibration::BaseStep step;
    step << draw.vector(spread_.base_shift_sigma), draw.vector(spread_.base_turn_sigma);
    truth.X_WB = calibration::moved(truth.X_WB, step);
    for (const auto& path : stiffnesses_)
      deflection::locate(truth.arm, path) *= std::exp(draw.normal(spread_.stiffness_sigma));
    return truth;
  }

 private:
  planner::Workcell about_;
  TruthSpread spread_;
  std::vector<deflection::ParameterPath> stiffnesses_;
};

}  // namespace tubeplan::app
