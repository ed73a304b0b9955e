// Numbers with units in YAML files: reader and writer.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"

namespace tubeplan::app {

/// Returns a number in internal units. Throws InputError for any other value.
[[nodiscard]] double readQuantity(const YamlNode& node, const Units& units, Dimension dimension);

/// Returns a list of three numbers [x, y, z] in internal units. Throws InputError for any other value.
[[nodiscard]] Eigen::Vector3d readVector(const YamlNode& node, const Units& units, Dimension dimension);

/// Returns the unit vector of a list of three numbers. Throws InputError for any other value and if all are zero.
[[nodiscard]] Eigen::Vector3d readDirection(const YamlNode& node);

/// Returns a number of a map in internal units; `otherwise` if the key is missing. Throws InputError for any other
/// value.
[[nodiscard]] double readQuantityOr(const YamlNode& map, std::string_view key, const Units& units, Dimension dimension,
                                    double otherwise);

/// Returns "[x, y, z]" in file units.
[[nodiscard]] std::string listText(const Eigen::VectorXd& values, const Units& units, Dimension dimension);

}  // namespace tubeplan::app
