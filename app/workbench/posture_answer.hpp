// State of a model at given joint angles: rigid and deflected frames and tip, the nearest objects, and the offset of
// the tip from a hole. Computed fast enough to follow a slider of the page.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Posture in a request: joint values and load, in internal units.
struct RequestedPosture {
  Eigen::VectorXd q;
  double load = 0;
  std::optional<int> hole;  ///< tube index in the sheet; std::nullopt without a hole
};

/// Returns the state of the model at a posture. Throws InputError if a formula of the cell has no value there, or if
/// the deflected shape does not converge.
[[nodiscard]] nlohmann::json answerPosture(const Model& model, const RequestedPosture& question);

/// Returns {distance, margin, pair, from, to} for the nearest pair of objects; null if the cell has no bodies, or if
/// the deflected shape does not converge.
[[nodiscard]] nlohmann::json clearanceOf(const Model& model, const Eigen::VectorXd& q, double load);

}  // namespace tubeplan::app
