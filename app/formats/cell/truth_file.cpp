#include "app/formats/cell/truth_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/formats/arm/joint_units.hpp"
#include "app/formats/cell/effects_reader.hpp"
#include "app/formats/quantities.hpp"
#include "app/formats/yaml/yaml_text.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

namespace {

std::string headText(const TruthFile& file) {
  const Units& units = file.cell.units;
  std::vector<std::string> encoders;
  for (const auto& joint : file.truth.arm.joints()) {
    encoders.push_back(formatNumber(units.toFile(joint.encoder_sigma, jointDimension(joint))));
  }
  return fmt::format(
      "# Ground truth of the simulated readings beside this file.\ncell: {}\ndesign: {}\nseed: {}\nreadings: "
      "{}\nunits: {{length: {}, angle: {}, force: {}, temperature: {}, time: {}}}\nsigma: {}\nencoder_sigma: "
      "[{}]\nspread: {}\nbase_error: [{}, {}]\n",
      yamlQuoted(file.cell.path), yamlQuoted(file.design.name), file.seed, file.campaign.measurements.size(),
      units.length().name, units.angle().name, units.force().name, units.temperature().name, units.time().name,
      formatNumber(units.toFile(file.design.sigma, dimension::kLength)), fmt::join(encoders, ", "),
      formatNumber(file.spread), formatNumber(units.toFile(file.base_shift, dimension::kLength)),
      formatNumber(units.toFile(file.base_turn, dimension::kAngle)));
}

std::string parametersText(const TruthFile& file) {
  const Units& units = file.cell.units;
  deflection::Arm truth = file.truth.arm;
  std::string text;
  for (const auto& parameter : identifiedParameters(file.cell)) {
    const Dimension unit = dimensionOf(parameter.quantity);
    text += fmt::format("  - {{name: {}, value: {}, nominal: {}, unit: {}}}\n", yamlQuoted(parameter.name),
                        formatNumber(units.toFile(deflection::locate(truth, parameter.path), unit)),
                        formatNumber(units.toFile(parameter.value, unit)), yamlQuoted(units.nameOf(unit)));
  }
  return text;
}

std::string basesText(const TruthFile& file) {
  const Units& units = file.cell.units;
  std::string text;
  for (const auto& base : file.truth.bases) {
    const std::string setup = base.setup.empty() ? "" : "setup: " + base.setup + ", ";
    text += fmt::format("  - {{{}position: {}, rpy: {}}}\n", setup,
                        listText(base.X_WB.translation(), units, dimension::kLength),
                        listText(deflection::fixedAnglesOf(base.X_WB.linear()), units, dimension::kAngle));
  }
  return text;
}

std::string pointsText(const TruthFile& file) {
  std::string text;
  for (const auto& point : file.campaign.points)
    text += fmt::format("  - {{name: {}, position: {}}}\n", point.name,
                        listText(point.p_W, file.cell.units, dimension::kLength));
  return text;
}

/// Returns the effects of the true arm that the cell's arm lacks.
std::string hiddenText(const TruthFile& file) {
  deflection::Arm hidden = file.truth.arm;
  hidden.effects.erase(hidden.effects.begin(),
                       hidden.effects.begin() + static_cast<long>(file.cell.arm.effects.size()));
  return effectsText(hidden, file.cell.units);
}

std::string listUnder(const std::string& key, const std::string& items) {
  return items.empty() ? key + ": []\n" : key + ":\n" + items;
}

}  // namespace

std::vector<deflection::Parameter> identifiedParameters(const Cell& cell) {
  std::vector<std::string> named;
  for (const auto& name : cell.identify)
    for (const auto& behind : calibration::namesBehind(cell.arm, name)) named.push_back(behind);
  std::vector<deflection::Parameter> parameters;
  for (const auto& parameter : deflection::parametersOf(cell.arm))
    if (std::find(named.begin(), named.end(), parameter.name) != named.end()) parameters.push_back(parameter);
  return parameters;
}

std::string truthYaml(const TruthFile& file) {
  return headText(file) + listUnder("parameters", parametersText(file)) + listUnder("bases", basesText(file)) +
         listUnder("points", pointsText(file)) + "hidden: " + hiddenText(file) + "\n";
}

}  // namespace tubeplan::app
