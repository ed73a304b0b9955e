// Reader and writer of numbers with units in YAML files.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"

namespace tubeplan::app {

/// Reads a number and converts it to internal units. Throws InputError for a value that is not a number.
[[nodiscard]] double readQuantity(const YamlNode& node, const Units& units, Dimension dimension);

/// Reads a list of three numbers [x, y, z] and converts them to internal units. Throws InputError for a value that is
/// not such a list.
[[nodiscard]] Eigen::Vector3d readVector(const YamlNode& node, const Units& units, Dimension dimension);

/// Reads a list of three numbers and returns the unit vector in its direction. Throws InputError for a value that is
/// not such a list, or if all three numbers are zero.
[[nodiscard]] Eigen::Vector3d readDirection(const YamlNode& node);

/// Reads the number at a key of a map and converts it to internal units; returns `otherwise` if the key is missing.
/// Throws InputError for a value that is not a number.
[[nodiscard]] double readQuantityOr(const YamlNode& map, std::string_view key, const Units& units, Dimension dimension,
                                    double otherwise);

/// Returns the values in file units as the text of a list: "[x, y, z]".
[[nodiscard]] std::string listText(const Eigen::VectorXd& values, const Units& units, Dimension dimension);

}  // namespace tubeplan::app
