// Reader of one link of an arm file: placement, joint, stiffnesses, beam and weights.
#pragma once

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Reads a link as a row of the arm. The key `follows` of a coupled joint names other rows and is not read. Throws
/// InputError, with the line in the file, for unknown, missing or ill-typed values.
[[nodiscard]] deflection::Row<double> readRow(const YamlNode& node, const Units& units);

}  // namespace tubeplan::app
