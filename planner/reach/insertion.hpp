// The tool inside a tube: how much play it has there.
#pragma once

#include <vector>

#include "planner/workcell.hpp"

namespace tubeplan::planner {

/// The least play [m] that the tool has in the tube of the hole centred at `hole_W` while the joints run straight from
/// posture to posture, by the deflected shape at each and midway; negative where it would touch, infinite where the tip
/// stays below the face. See tubesheets::playInTube.
[[nodiscard]] double playInTube(const Workcell& cell, const Eigen::Vector3d& hole_W,
                                const std::vector<Eigen::VectorXd>& postures);

}  // namespace tubeplan::planner
