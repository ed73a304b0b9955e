// Export of the current model's arm as URDF.
#pragma once

#include <filesystem>
#include <string>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Returns the place of the robot description from which a cell is made: beside the cell, with the cell's name.
[[nodiscard]] inline std::filesystem::path urdfPathFor(std::filesystem::path cell) {
  return cell.replace_extension(".urdf");
}

/// Returns the arm as a rigid robot in URDF. If a URDF file with the cell's name lies beside the cell, as after an
/// import, returns that file with the arm's origins and limits, so that shapes and masses stay. Otherwise returns a new
/// robot, with the reason if the file is of another robot. Comments list what URDF cannot express.
[[nodiscard]] std::string exportedUrdf(const Session& session);

}  // namespace tubeplan::app
