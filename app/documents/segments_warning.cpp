#include "app/documents/segments_warning.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/documents/pose_json.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::app {

std::string segmentsWarning(const Cell& cell, const planner::Workcell& placed,
                            const std::vector<Eigen::VectorXd>& postures) {
  constexpr std::size_t kCheckedPostures = 16;
  Cell placed_cell = cell;
  placed_cell.arm = placed.arm;
  const Eigen::Vector3d gravity_B = deflection::gravityInBase(placed_cell.arm, placed.X_WB);
  std::string worst;
  double most = 0;
  for (std::size_t k = 0; k < postures.size(); k += std::max<std::size_t>(1, postures.size() / kCheckedPostures)) {
    const deflection::Posture posture{postures[k], placed.load, gravity_B};
    const auto found =
        segmentsJson(placed_cell, posture, deflection::solveFlexibleKinematics(placed_cell.arm, posture));
    const std::string warning = found["warning"];
    const double error = found["tip_error"].is_number() ? found["tip_error"].get<double>() : 0;
    if (warning.empty() || (!worst.empty() && error <= most)) continue;
    worst = warning;
    most = error;
  }
  return worst;
}

}  // namespace tubeplan::app
