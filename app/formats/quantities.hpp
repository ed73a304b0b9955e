// Numbers with units out of a YAML file, and into one.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"

namespace tubeplan::app {

/// Internal units. All throw InputError where the value is not such a number or list of numbers.
[[nodiscard]] double readQuantity(const YamlNode& node, const Units& units, Dimension dimension);

/// Three of them: [x, y, z].
[[nodiscard]] Eigen::Vector3d readVector(const YamlNode& node, const Units& units, Dimension dimension);

/// A unit vector. Refused: all three numbers zero.
[[nodiscard]] Eigen::Vector3d readDirection(const YamlNode& node);

/// Of a map; `otherwise` (internal units) where the key is missing.
[[nodiscard]] double readQuantityOr(const YamlNode& map, std::string_view key, const Units& units, Dimension dimension,
                                    double otherwise);

/// "[x, y, z]", in file units.
[[nodiscard]] std::string listText(const Eigen::VectorXd& values, const Units& units, Dimension dimension);

}  // namespace tubeplan::app
