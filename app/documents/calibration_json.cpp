#include "app/documents/calibration_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/documents/base_verdict.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/pose_json.hpp"
#include "app/files/input_error.hpp"
#include "app/files/joint_units.hpp"
#include "app/files/units.hpp"
#include "app/files/units_json.hpp"

namespace tubeplan::app {

namespace {

using calibration::BaseCalibration, calibration::CalibrationStatus;

/// Covariance in file units; order x, y, z, then the turns about them.
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

/// What the touches say of the arm's numbers.
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

nlohmann::json suspectReadingsJson(const BaseCalibration& result, const Cell& cell) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& suspect : result.suspect_readings) {
    const auto& joint = cell.arm.joint(suspect.joint);
    list.push_back({{"touch", suspect.touch},
                    {"joint", joint.name},
                    {"off", rounded(suspect.off / cell.units.factor(jointDimension(joint)))},
                    {"unit", cell.units.nameOf(jointDimension(joint))},
                    {"p_value", suspect.p_value}});
  }
  return list;
}

/// What is left at each touch by the base and the arm as found.
std::string residualsText(const BaseCalibration& result, const Units& units) {
  const auto length = [&](double metres) { return metres / units.factor(dimension::kLength); };
  const int digits = lengthDecimals(units);
  std::string text;
  for (const auto& touch : result.residuals)
    text += fmt::format("  touch {:<4} {:<8} off by {:+.{}f} {:+.{}f} {:+.{}f} {}\n", nameInLine(touch.id),
                        nameInLine(touch.hole), length(touch.residual_W.x()), digits, length(touch.residual_W.y()),
                        digits, length(touch.residual_W.z()), digits, units.length().name);
  return text;
}

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
  json["suspect_readings"] = suspectReadingsJson(result, cell);
  json["odd_touch"] = result.odd_touch < 0
                          ? nlohmann::json()
                          : nlohmann::json(result.residuals[static_cast<std::size_t>(result.odd_touch)].id);
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
  const Units& units = cell.units;
  if (result.status != CalibrationStatus::kDone)
    return "calibration " + std::string(statusName(result.status)) + ": " + result.reason + "\n" +
           residualsText(result, units) + baseVerdictText(judgeBase(result, cell), result, units, in_full) +
           "the base stays where it was: what is planned holds " + wordsOf(standingOf(cell)) + "\n";
  const auto length = [&](double metres) { return metres / units.factor(dimension::kLength); };
  const auto angle = [&](double radians) { return radians / units.factor(dimension::kAngle); };
  const std::string unit(units.length().name), turn(units.angle().name);
  const nlohmann::json base = poseJson(result.X_WB, units);
  const Eigen::VectorXd sigma = result.covariance.diagonal().cwiseSqrt();
  const int digits = lengthDecimals(units);
  const auto fixed = [&](double metres) { return fmt::format("{:.{}f}", length(metres), digits); };
  std::string text = fmt::format("base  position {:.{}f} {:.{}f} {:.{}f} {}  rpy {:.4f} {:.4f} {:.4f} {}\n",
                                 base["position"][0].get<double>(), digits, base["position"][1].get<double>(), digits,
                                 base["position"][2].get<double>(), digits, unit, base["rpy"][0].get<double>(),
                                 base["rpy"][1].get<double>(), base["rpy"][2].get<double>(), turn);
  text += fmt::format("sigma position {} {} {} {}  turn {:.4f} {:.4f} {:.4f} {}\n", fixed(sigma[0]), fixed(sigma[1]),
                      fixed(sigma[2]), unit, angle(sigma[3]), angle(sigma[4]), angle(sigma[5]), turn);
  text += fmt::format("fit   rms {} {}, chi-square {:.2f} for {} degrees of freedom{}\n", fixed(result.rms), unit,
                      result.chi2, result.degrees_of_freedom,
                      result.degrees_of_freedom > 0 ? fmt::format(" (p = {:.3g})", result.p_value) : "");
  text += residualsText(result, units);
  for (const auto& check : result.distances) {
    if (!in_full) break;
    text += fmt::format("  {} to {}: {} by the arm, {} on the sheet, {:+.{}f} (sigma {}) {}\n", nameInLine(check.from),
                        nameInLine(check.to), fixed(check.by_arm), fixed(check.on_sheet),
                        length(check.by_arm - check.on_sheet), digits, fixed(check.sigma), unit);
  }
  return text + baseVerdictText(judgeBase(result, cell), result, units, in_full);
}

}  // namespace tubeplan::app
