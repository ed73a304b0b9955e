// Arm file and cell file made of a robot description in URDF.
#pragma once

#include <string>

#include "app/formats/units.hpp"
#include "app/formats/urdf/urdf_reader.hpp"

namespace tubeplan::app {

/// Returns the units of arms that were read from URDF: m, deg, N.
[[nodiscard]] const Units& urdfUnits();

struct ImportedUrdf {
  UrdfArm read;
  std::string arm;  ///< text of the arm file
};

/// Returns the arm of a URDF text as an arm file, which names `file` as its source. Throws InputError as parseUrdf().
[[nodiscard]] ImportedUrdf importUrdf(const std::string& text, const std::string& file, const std::string& tip = "");

/// Returns the text of a cell with the arm in `arm_file` and its solids, whose base is not known.
[[nodiscard]] std::string cellOfUrdf(const UrdfArm& read, const std::string& arm_file);

}  // namespace tubeplan::app
