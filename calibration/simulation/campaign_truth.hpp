// The arm as it truly is and where it truly stands, about an arm and a base as stated.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deflection/parameters.hpp"

namespace tubeplan::calibration {

/// A base pose; its name is empty where there is only one.
struct TrueBase {
  std::string setup;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
};

/// What readings are made with. Whatever else the arm does is part of `arm`.
struct CampaignTruth {
  deflection::Arm arm;
  std::vector<TrueBase> bases;  ///< one for each set-up
};

struct TruthOptions {
  std::vector<deflection::Parameter> parameters;  ///< of which the stiffnesses are spread
  double spread = 0;                              ///< standard deviation of a stiffness's logarithm: 0.1 is 10 %
  double base_shift_sigma = 0;                    ///< m per coordinate, about the base as stated
  double base_turn_sigma = 0;                     ///< rad per axis
  int setups = 1;
  std::uint64_t seed = 1;
};

/// Draws it. Without spread and base error it is the arm and the base as stated, for every set-up.
[[nodiscard]] CampaignTruth drawTruth(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                      const TruthOptions& options = {});

}  // namespace tubeplan::calibration
