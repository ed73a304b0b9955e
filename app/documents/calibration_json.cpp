#include "app/documents/calibration_json.hpp"

#include <nlohmann/json.hpp>

#include "app/documents/base_verdict.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/pose_json.hpp"
#include "app/formats/arm/joint_units.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"

namespace tubeplan::app {

namespace {

using calibration::BaseCalibration, calibration::CalibrationStatus;

/// Returns a pose covariance in file units; order: x, y, z, then the rotations about these axes.
nlohmann::json covarianceJson(const Eigen::Matrix<double, 6, 6>& covariance, const Units& units) {
  Eigen::Matrix<double, 6, 1> scale;
  scale << Eigen::Vector3d::Constant(1 / units.factor(dimension::kLength)),
      Eigen::Vector3d::Constant(1 / units.factor(dimension::kAngle));
  const Eigen::Matrix<double, 6, 6> scaled = scale.asDiagonal() * covariance * scale.asDiagonal();
  nlohmann::json rows = nlohmann::json::array();
  for (int i = 0; i < 6; ++i) {
    rows.push_back(nlohmann::json::array());
    for (int j = 0; j < 6; ++j) rows.back().push_back(rounded(scaled(i, j)));
  }
  return rows;
}

/// Returns the arm parameters that were fitted together with the base, each with its standard deviation before and
/// after the touches.
nlohmann::json numbersJson(const BaseCalibration& result, const Units& units) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& number : result.numbers) {
    const double unit = units.factor(dimensionOf(number.quantity));
    list.push_back({{"name", number.name},
                    {"filed", rounded(number.filed / unit)},
                    {"value", rounded(number.value / unit)},
                    {"sigma_before", rounded(number.prior / unit)},
                    {"sigma", rounded(number.posterior / unit)},
                    {"unit", units.nameOf(dimensionOf(number.quantity))}});
  }
  return list;
}

nlohmann::json suspectMeasurementsJson(const BaseCalibration& result, const Cell& cell) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& suspect : result.suspect_measurements) {
    const auto& joint = cell.arm.joint(suspect.joint);
    list.push_back({{"touch", suspect.touch},
                    {"joint", joint.name},
                    {"off", rounded(suspect.off / cell.units.factor(jointDimension(joint)))},
                    {"unit", cell.units.nameOf(jointDimension(joint))},
                    {"p_value", suspect.p_value}});
  }
  return list;
}

constexpr TextLine kResidualWords[] = {
    {"residuals", "  touch {id:<4n} {hole:<8n} off by {residual:+l} {units/length}\n"}};

constexpr TextLine kCalibrationWords[] = {
    {"", "base  position {base/position:l} {units/length}  rpy {base/rpy:.4f} {units/angle}\n"},
    {"", "sigma position {sigma/position:l} {units/length}  turn {sigma/rotation:.4f} {units/angle}\n"},
    {"", "fit   rms {rms:l} {units/length}, chi-square {chi2:.2f} for {degrees_of_freedom} degrees of freedom"},
    {"+degrees_of_freedom", " (p = {p_value:.3g})"},
    {"", "\n", kResidualWords}};

constexpr TextLine kFromNominal[] = {
    {"pitches", ", {pitches/0:+.2f} pitches along x and {pitches/1:+.2f} along y", {}, {}, 1},
    {"", " (sigma {sigma/distance:.2g}) and {angle:.4r} {units/angle} (sigma {sigma/angle:.2g})\n"}};
constexpr TextLine kBaseVerdictWords[] = {{"nominal", "from nominal {distance:.4r} {units/length}", kFromNominal},
                                          {"warnings", "warning: {}\n"}};
constexpr TextLine kToDoWords[] = {{"to_do", "  to do: {}\n"}};

constexpr TextLine kDistanceWords[] = {{"distances",
                                        "  {from:n} to {to:n}: {by_arm:l} by the arm, {on_sheet:l} on the sheet, "
                                        "{difference:+l} (sigma {sigma:l}) {units/length}\n"}};

}  // namespace

nlohmann::json calibrationJson(const BaseCalibration& result, const Cell& cell) {
  const Units& units = cell.units;
  nlohmann::json json = {{"status", statusName(result.status)},
                         {"reason", result.reason},
                         {"suspects", result.suspects},
                         {"units", unitsJson(units)}};
  if (result.residuals.empty()) return json;
  if (result.status == CalibrationStatus::kDone) {
    json["base"] = placedBaseJson(result.X_WB, standingOf(cell, &result), units);
    json["covariance"] = covarianceJson(result.covariance, units);
    const Eigen::VectorXd sigma = result.covariance.diagonal().cwiseSqrt();
    json["sigma"] = {{"position", vectorJson(sigma.head(3), units, dimension::kLength)},
                     {"rotation", vectorJson(sigma.tail(3), units, dimension::kAngle)}};
    json["numbers"] = numbersJson(result, units);
  }
  json["suspect_readings"] = suspectMeasurementsJson(result, cell);
  json["odd_touch"] = result.outlier_touch < 0
                          ? nlohmann::json()
                          : nlohmann::json(result.residuals[static_cast<std::size_t>(result.outlier_touch)].id);
  json["rms"] = lengthOf(result.rms, units);
  json["chi2"] = result.chi2;
  json["degrees_of_freedom"] = result.degrees_of_freedom;
  json["p_value"] = result.p_value;
  json["residuals"] = nlohmann::json::array();
  for (const auto& touch : result.residuals)
    json["residuals"].push_back({{"id", touch.id},
                                 {"hole", touch.hole},
                                 {"residual", vectorJson(touch.residual_W, units, dimension::kLength)},
                                 {"size", lengthOf(touch.residual_W.norm(), units)},
                                 {"sigma", vectorJson(touch.sigma_W, units, dimension::kLength)}});
  json["distances"] = nlohmann::json::array();
  for (const auto& check : result.distances)
    json["distances"].push_back({{"from", check.from},
                                 {"to", check.to},
                                 {"by_arm", lengthOf(check.by_arm, units)},
                                 {"on_sheet", lengthOf(check.on_sheet, units)},
                                 {"difference", lengthOf(check.by_arm - check.on_sheet, units)},
                                 {"sigma", lengthOf(check.sigma, units)}});
  json.update(baseVerdictJson(judgeBase(result, cell), result, units));
  return json;
}

std::string calibrationText(const BaseCalibration& result, const Cell& cell, bool in_full) {
  const nlohmann::json figures = calibrationJson(result, cell);
  const std::string verdict = textOf(figures, kBaseVerdictWords) + (in_full ? textOf(figures, kToDoWords) : "");
  if (result.status != CalibrationStatus::kDone)
    return textOf(figures, "calibration {status}: {reason}\n") + textOf(figures, kResidualWords) + verdict +
           "the base has not moved: existing plans remain valid " + wordsOf(standingOf(cell)) + "\n";
  return textOf(figures, kCalibrationWords) + (in_full ? textOf(figures, kDistanceWords) : "") + verdict;
}

}  // namespace tubeplan::app
