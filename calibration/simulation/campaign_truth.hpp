// The true arm and base of a simulation, varied about a stated arm and base.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deflection/parameters.hpp"

namespace tubeplan::calibration {

/// A base pose; its name is empty if there is only one.
struct TrueBase {
  std::string setup;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
};

/// The truth that readings are made with. All other behaviour of the arm is part of `arm`.
struct CampaignTruth {
  deflection::Arm arm;
  std::vector<TrueBase> bases;  ///< base pose of each set-up
};

struct TruthOptions {
  std::vector<deflection::Parameter> parameters;  ///< parameters, of which the stiffnesses are varied
  double spread = 0;                              ///< standard deviation of a stiffness's logarithm: 0.1 is 10 %
  double base_shift_sigma = 0;                    ///< per coordinate, about the stated base [m]
  double base_turn_sigma = 0;                     ///< per axis [rad]
  int setups = 1;
  std::uint64_t seed = 1;
};

/// Draws a truth. Without spread and base error it is the stated arm and base, for every set-up.
[[nodiscard]] CampaignTruth drawTruth(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                      const TruthOptions& options = {});

}  // namespace tubeplan::calibration
