// Whether the beams have segments enough where an arm is sent.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// The sentence of segmentsJson() for the posture where it is worst, out of some sixteen spread over these, under the
/// load of `placed` and by its arm and base; empty where the segments stated do everywhere.
[[nodiscard]] std::string segmentsWarning(const Cell& cell, const planner::Workcell& placed,
                                          const std::vector<Eigen::VectorXd>& postures);

}  // namespace tubeplan::app
