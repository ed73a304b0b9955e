// Postures under holes spread over a cell's sheet: the places of work, for studies of its accuracy.
#pragma once

#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/hooks.hpp"

namespace tubeplan::app {

struct SpreadPostures {
  std::vector<int> tubes;                 ///< tubes in reach, as indices in the sheet
  std::vector<Eigen::VectorXd> postures;  ///< first branch that reaches each of these tubes
  int asked = 0;                          ///< number of holes, those out of reach included
};

/// Returns postures for at most that many holes; fewer for arms whose inverse kinematics is a search. None if the cell
/// has no sheet or does not state the direction in which the tool enters. Collisions are not checked. The result is
/// unusable once `stop` has returned true.
[[nodiscard]] SpreadPostures spreadPostures(const CellModel& cell, const deflection::Arm& arm,
                                            const Eigen::Isometry3d& X_WB, std::size_t most,
                                            const calibration::StopQuestion& stop = {});

}  // namespace tubeplan::app
