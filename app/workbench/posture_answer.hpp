// State of a model at given joint readings: tip and frames, rigid and deflected, the nearest objects, and the centring
// of the tip under a hole. Fast enough for a slider.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Posture of a request: joints and load in internal units.
struct AskedPosture {
  Eigen::VectorXd q;
  double load = 0;
  std::optional<int> hole;  ///< index in the sheet
};

/// Returns the state of the model. Throws InputError for a posture at which a formula of the cell has no value, or
/// whose shape does not converge.
[[nodiscard]] nlohmann::json answerPosture(const Model& model, const AskedPosture& question);

/// Returns {distance, margin, pair, from, to}; null if the cell has no bodies, or the shape does not converge.
[[nodiscard]] nlohmann::json clearanceOf(const Model& model, const Eigen::VectorXd& q, double load);

}  // namespace tubeplan::app
