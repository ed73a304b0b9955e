#include "app/formats/cell/priors_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

struct GroupOfNumbers {
  const char* name;
  Dimension unit;
  double calibration::Priors::*sigma;
};

constexpr GroupOfNumbers kGroups[] = {{"length", dimension::kLength, &calibration::Priors::length},
                                      {"angle", dimension::kAngle, &calibration::Priors::angle},
                                      {"tip", dimension::kLength, &calibration::Priors::tip},
                                      {"turn", dimension::kAngle, &calibration::Priors::turn}};

std::vector<std::string> namesFor(const Cell& cell) {
  std::vector<std::string> names;
  for (const auto& group : kGroups) names.emplace_back(group.name);
  for (const auto& parameter : deflection::parametersOf(cell.arm)) names.push_back(parameter.name);
  return names;
}

/// Converts the standard deviation of a parameter to the fit's variable. For a stiffness, the variable is the
/// compliance, so `sigma` is divided by the square of the stiffness.
double asOfVariable(const deflection::Parameter& parameter, double sigma) {
  return deflection::isStiffness(parameter.quantity) && parameter.path.effect < 0
             ? sigma / (parameter.value * parameter.value)
             : sigma;
}

/// Sets a prior; returns false if no parameter or group of parameters has this name.
bool takePrior(const std::string& name, double sigma, Cell& cell) {
  for (const auto& group : kGroups)
    if (name == group.name) {
      cell.priors.*group.sigma = cell.units.toInternal(sigma, group.unit);
      return true;
    }
  const auto parameter = deflection::findParameter(cell.arm, name);
  if (!parameter) return false;
  cell.priors.named[name] = asOfVariable(*parameter, cell.units.toInternal(sigma, dimensionOf(parameter->quantity)));
  return true;
}

const char* const kExpectedName = "length, angle, tip, or the path of a number in the arm file";
const char* const kExpectedSigma = "a standard deviation above zero";

}  // namespace

void readPriors(const YamlNode& node, Cell& cell) {
  if (node.kind != YamlNode::Kind::kMap) node.fail("a map of names and standard deviations");
  for (std::size_t k = 0; k < node.keys.size(); ++k) {
    const std::string& key = node.keys[k];
    const YamlNode& value = node.items[k];
    const double sigma = value.number();
    if (!(sigma > 0)) value.fail(fmt::format("{}", sigma), kExpectedSigma, "");
    if (!takePrior(key, sigma, cell))
      value.fail("a prior for '" + key + "', which is no parameter of this cell", kExpectedName,
                 suggestion(key, namesFor(cell)));
  }
}

void takePriors(const std::vector<std::string>& texts, Cell& cell) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  for (const auto& text : texts) {
    if (text == "none") {
      cell.priors = {kNone, kNone, kNone, kNone, kNone, {}};
      continue;
    }
    const std::size_t equals = text.find('=');
    const auto sigma =
        equals == std::string::npos ? std::nullopt : tubesheets::parseNumber(std::string_view(text).substr(equals + 1));
    if (!sigma || !(*sigma > 0))
      throw InputError("--prior", inQuotes(text), "none, or NAME=SIGMA with a sigma above zero");
    const std::string name = text.substr(0, equals);
    if (!takePrior(name, *sigma, cell))
      throw InputError("--prior", inQuotes(name), kExpectedName, suggestion(name, namesFor(cell)));
  }
}

}  // namespace tubeplan::app
