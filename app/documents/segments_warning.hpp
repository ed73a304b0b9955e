// Warning if the beams have too few segments at an arm's postures.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Returns the warning of segmentsJson() at the worst of about sixteen postures spread over the given ones, with the
/// load, arm and base of `placed`; empty if the stated segments suffice everywhere.
[[nodiscard]] std::string segmentsWarning(const Cell& cell, const planner::Workcell& placed,
                                          const std::vector<Eigen::VectorXd>& postures);

}  // namespace tubeplan::app
