// Where a model is at given joint readings: tip and frames, rigid and deflected, what comes nearest, and how well the
// tip is centred under a hole. Quick enough for a slider.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Joints and load in internal units.
struct AskedPosture {
  Eigen::VectorXd q;
  double load = 0;
  std::optional<int> hole;  ///< index in the sheet
};

/// Throws InputError for a posture at which a formula of the cell has no value, or whose shape does not converge.
[[nodiscard]] nlohmann::json answerPosture(const Model& model, const AskedPosture& question);

/// {distance, margin, pair, from, to}: null where the cell has no bodies, or the shape does not converge.
[[nodiscard]] nlohmann::json clearanceOf(const Model& model, const Eigen::VectorXd& q, double load);

}  // namespace tubeplan::app
