// The true arm and base poses of a simulation, varied about a stated arm and base.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deflection/parameters.hpp"

namespace tubeplan::calibration {

/// A true base pose; `setup` is empty if there is only one set-up.
struct TrueBase {
  std::string setup;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
};

/// True arm and base poses from which measurements are simulated. Hidden effects are part of `arm`.
struct CampaignTruth {
  deflection::Arm arm;
  std::vector<TrueBase> bases;  ///< base pose of each set-up
};

struct TruthOptions {
  std::vector<deflection::Parameter> parameters;  ///< parameters of the arm; only its stiffnesses are varied
  double spread = 0;            ///< standard deviation of the logarithm of each stiffness: 0.1 is about 10 %
  double base_shift_sigma = 0;  ///< standard deviation of the base's position about the stated base, per coordinate [m]
  double base_turn_sigma = 0;   ///< standard deviation of the base's rotation about the stated base, per axis [rad]
  int setups = 1;
  std::uint64_t seed = 1;
};

/// Draws a true arm and true base poses. Without spread and base errors, they are the stated arm and, for every set-up,
/// the stated base.
[[nodiscard]] CampaignTruth drawTruth(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                      const TruthOptions& options = {});

}  // namespace tubeplan::calibration
