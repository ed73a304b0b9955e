// Warning that the beams of an arm have too few segments for given postures.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Returns the warning of segmentsJson() for the posture with the largest error among about sixteen of those given,
/// with the arm, base and load of `placed`; empty if the number of segments suffices in all these postures.
[[nodiscard]] std::string segmentsWarning(const Cell& cell, const planner::Workcell& placed,
                                          const std::vector<Eigen::VectorXd>& postures);

}  // namespace tubeplan::app
