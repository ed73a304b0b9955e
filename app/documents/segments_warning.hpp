// Warning if the beams of an arm have too few segments in given postures.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Returns the warning of segmentsJson() for the worst of about sixteen of the given postures, with the arm, base and
/// load of `placed`; empty if the number of segments suffices in all these postures.
[[nodiscard]] std::string segmentsWarning(const Cell& cell, const planner::Workcell& placed,
                                          const std::vector<Eigen::VectorXd>& postures);

}  // namespace tubeplan::app
