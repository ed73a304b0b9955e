#include "app/formats/cell/uncertainty_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/formats/quantities.hpp"
#include "app/storage/suggestion.hpp"

namespace tubeplan::app {

namespace {

using calibration::ArmUncertainty;
using Eigen::Index, Eigen::MatrixXd;

struct KindOfNumber {
  const char* key;
  Dimension unit;
  double ArmUncertainty::*sigma;
};

constexpr KindOfNumber kKinds[] = {
    {"stiffness", dimension::kNone, &ArmUncertainty::stiffness}, {"weight", dimension::kNone, &ArmUncertainty::weight},
    {"zero", dimension::kAngle, &ArmUncertainty::zero},          {"axis", dimension::kAngle, &ArmUncertainty::axis},
    {"length", dimension::kLength, &ArmUncertainty::length},     {"tip", dimension::kLength, &ArmUncertainty::tip}};

/// Returns the dimension of a parameter of the arm, or of one of baseStepNames(); std::nullopt if the name is unknown.
std::optional<Dimension> dimensionOfNumber(const std::string& name, const deflection::Arm& arm) {
  const auto& steps = calibration::baseStepNames();
  if (const auto step = std::find(steps.begin(), steps.end(), name); step != steps.end())
    return step - steps.begin() < 3 ? dimension::kLength : dimension::kAngle;
  const auto parameter = deflection::findParameter(arm, name);
  return parameter ? std::optional(dimensionOf(parameter->quantity)) : std::nullopt;
}

double readSigma(const YamlNode& node, const Units& units, Dimension dimension) {
  const double sigma = readQuantity(node, units, dimension);
  if (!(sigma >= 0)) node.fail("a standard deviation of zero or more");
  return sigma;
}

/// Reads the lower triangle of a correlation matrix without its diagonal: one list for each parameter except the first.
MatrixXd readCorrelation(const YamlNode& node, std::size_t numbers) {
  constexpr double kRounding = 1e-5;
  const auto count = static_cast<Index>(numbers);
  MatrixXd correlation = MatrixXd::Identity(count, count);
  const auto& rows = node.list(numbers - 1, fmt::format("{} lists of correlations", numbers - 1));
  for (Index i = 1; i < count; ++i) {
    const YamlNode& row = rows[static_cast<std::size_t>(i - 1)];
    const auto& items = row.list(static_cast<std::size_t>(i), fmt::format("{} correlations", i));
    for (Index j = 0; j < i; ++j) correlation(i, j) = correlation(j, i) = items[static_cast<std::size_t>(j)].number();
  }
  if (correlation.cwiseAbs().maxCoeff() > 1 + kRounding ||
      correlation.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() < -kRounding * static_cast<double>(count))
    node.failWithProblem("these correlations contradict each other", "write the correlations of a covariance matrix");
  return correlation;
}

void readDetermined(const YamlNode& node, const Cell& cell, ArmUncertainty& uncertainty) {
  node.expectKeys({"numbers", "sigma", "correlation"}, {});
  const auto& names = node.at("numbers").list();
  const auto& sigmas = node.at("sigma").list(names.size(), fmt::format("{} standard deviations", names.size()));
  if (names.empty()) return;
  Eigen::VectorXd sigma(static_cast<Index>(names.size()));
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string name = names[k].text();
    const auto dimension = dimensionOfNumber(name, cell.arm);
    if (!dimension)
      names[k].fail("the unknown number '" + name + "'", "the path of a number in the arm file",
                    suggestion(name, calibration::freeableNames(cell.arm)));
    uncertainty.determined.push_back(name);
    sigma[static_cast<Index>(k)] = readSigma(sigmas[k], cell.units, *dimension);
  }
  uncertainty.covariance =
      sigma.asDiagonal() * readCorrelation(node.at("correlation"), names.size()) * sigma.asDiagonal();
}

std::string determinedText(const ArmUncertainty& uncertainty, const deflection::Arm& arm, const Units& units) {
  const Eigen::VectorXd sigma = uncertainty.covariance.diagonal().cwiseSqrt();
  std::vector<std::string> names, sigmas, rows;
  for (std::size_t k = 0; k < uncertainty.determined.size(); ++k) {
    const auto i = static_cast<Index>(k);
    names.push_back('"' + uncertainty.determined[k] + '"');
    sigmas.push_back(
        fmt::format("{:.6g}", sigma[i] / units.factor(*dimensionOfNumber(uncertainty.determined[k], arm))));
    if (k == 0) continue;
    std::vector<std::string> row;
    for (Index j = 0; j < i; ++j)
      row.push_back(fmt::format("{:.9g}", uncertainty.covariance(i, j) / (sigma[i] * sigma[j])));
    rows.push_back(fmt::format("      [{}]", fmt::join(row, ", ")));
  }
  return fmt::format("{{numbers: [{}],\n    sigma: [{}],\n    correlation: [\n{}]}}", fmt::join(names, ", "),
                     fmt::join(sigmas, ", "), fmt::join(rows, ",\n"));
}

}  // namespace

ArmUncertainty readUncertainty(const YamlNode& node, const Cell& cell) {
  if (node.kind == YamlNode::Kind::kScalar && node.scalar == "none") return ArmUncertainty::none();
  if (node.kind != YamlNode::Kind::kMap) node.fail("none, or a map of standard deviations");
  std::vector<std::string> keys{"determined"};
  for (const auto& kind : kKinds) keys.emplace_back(kind.key);
  node.expectKeys({}, keys);
  ArmUncertainty uncertainty;
  for (const auto& kind : kKinds)
    if (const YamlNode* sigma = node.find(kind.key)) uncertainty.*kind.sigma = readSigma(*sigma, cell.units, kind.unit);
  if (const YamlNode* determined = node.find("determined")) readDetermined(*determined, cell, uncertainty);
  return uncertainty;
}

std::string uncertaintyText(const ArmUncertainty& uncertainty, const deflection::Arm& arm, const Units& units) {
  std::string text;
  const ArmUncertainty usual;
  for (const auto& kind : kKinds)
    if (uncertainty.*kind.sigma != usual.*kind.sigma)
      text += fmt::format("{}: {}, ", kind.key, formatNumber(units.toFile(uncertainty.*kind.sigma, kind.unit)));
  if (!uncertainty.determined.empty()) text += "\n  determined: " + determinedText(uncertainty, arm, units);
  return "{" + text + "}";
}

ArmUncertainty knownOf(ArmUncertainty uncertainty, const deflection::Arm& arm) {
  std::vector<Index> kept;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < uncertainty.determined.size(); ++k) {
    if (!dimensionOfNumber(uncertainty.determined[k], arm)) continue;
    kept.push_back(static_cast<Index>(k));
    names.push_back(uncertainty.determined[k]);
  }
  uncertainty.covariance = MatrixXd(uncertainty.covariance(kept, kept));
  uncertainty.determined = std::move(names);
  return uncertainty;
}

}  // namespace tubeplan::app
