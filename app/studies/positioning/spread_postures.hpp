// Postures under holes spread over a cell's sheet: where an arm works, for studies of how well it does.
#pragma once

#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/hooks.hpp"

namespace tubeplan::app {

struct SpreadPostures {
  std::vector<int> tubes;                 ///< in reach, indices in the sheet
  std::vector<Eigen::VectorXd> postures;  ///< of each of them, the first branch that reaches it
  int asked = 0;                          ///< holes, those out of reach included
};

/// At most so many holes; fewer for arms whose inverse kinematics is a search. None where the cell has no sheet or does
/// not say which way the tool enters. Collisions are not asked about. Of no use once `stop` has said yes.
[[nodiscard]] SpreadPostures spreadPostures(const CellModel& cell, const deflection::Arm& arm,
                                            const Eigen::Isometry3d& X_WB, std::size_t most,
                                            const calibration::StopQuestion& stop = {});

}  // namespace tubeplan::app
