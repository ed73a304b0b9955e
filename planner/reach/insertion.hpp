// Clearance between the tool and the tube that it enters.
#pragma once

#include <vector>

#include "planner/workcell.hpp"

namespace tubeplan::planner {

/// Returns the smallest clearance [m] of the tool in the tube whose hole is centred at `hole_W`, while the joints move
/// straight from posture to posture. The clearance is computed on the deflected shape at each posture and midway.
/// Negative if the tool would touch the tube, infinite if the tip stays below the face. See tubesheets::playInTube().
[[nodiscard]] double playInTube(const Workcell& cell, const Eigen::Vector3d& hole_W,
                                const std::vector<Eigen::VectorXd>& postures);

}  // namespace tubeplan::planner
