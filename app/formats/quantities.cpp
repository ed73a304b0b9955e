#include "app/formats/quantities.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>

namespace tubeplan::app {

double readQuantity(const YamlNode& node, const Units& units, Dimension dimension) {
  return units.toInternal(node.number(), dimension);
}

Eigen::Vector3d readVector(const YamlNode& node, const Units& units, Dimension dimension) {
  const auto& items = node.list(3, "a list of three numbers");
  Eigen::Vector3d v;
  for (int k = 0; k < 3; ++k) v[k] = readQuantity(items[static_cast<std::size_t>(k)], units, dimension);
  return v;
}

Eigen::Vector3d readDirection(const YamlNode& node) {
  const Eigen::Vector3d v = readVector(node, Units(), dimension::kNone);
  if (v.norm() == 0) node.fail("a direction of length zero", "three numbers that are not all zero", "");
  return v.stableNormalized();
}

double readQuantityOr(const YamlNode& map, std::string_view key, const Units& units, Dimension dimension,
                      double otherwise) {
  const YamlNode* node = map.find(key);
  return node ? readQuantity(*node, units, dimension) : otherwise;
}

std::string listText(const Eigen::VectorXd& values, const Units& units, Dimension dimension) {
  std::vector<std::string> numbers;
  for (const double value : values) numbers.push_back(formatNumber(units.toFile(value, dimension)));
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

}  // namespace tubeplan::app
