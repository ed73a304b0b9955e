#include "app/predicted_centring.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/workcell.hpp"
#include "deflection/rigid_branches.hpp"
#include "planner/compensation.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

using calibration::CentringForecastStatus, calibration::ForecastFigure;
using Eigen::VectorXd;

constexpr std::size_t kHoles = 200;
constexpr std::size_t kHolesOfSlowArms = 20;  // whose inverse kinematics is a search

struct Reached {
  std::vector<int> tubes;
  std::vector<VectorXd> postures;
};

std::vector<int> holesToLookAt(const Cell& cell) {
  const std::size_t most = deflection::isTurretArm(cell.arm) ? kHoles : kHolesOfSlowArms;
  return tubesheets::selectTubes(*cell.sheet, tubesheets::spreadRequest(*cell.sheet, most)).tube_indices;
}

Reached reach(const Cell& cell, const calibration::PlacedArm& placed, const std::vector<int>& tubes,
              const calibration::StopQuestion& stop) {
  planner::Workcell work;
  work.arm = placed.arm;
  work.X_WB = placed.placings.back().X_WB;
  planner::CompensationOptions options;
  options.with_approach = false;
  std::vector<VectorXd> postures(tubes.size());
  oneapi::tbb::parallel_for(std::size_t{0}, tubes.size(), [&](std::size_t k) {
    if (calibration::shouldStop(stop)) return;
    const auto& tube = cell.sheet->tubes[static_cast<std::size_t>(tubes[k])];
    const auto branches = planner::compensate(work, planner::holeCentre(tube), options);
    if (!branches.empty() && branches.front().status == deflection::BranchStatus::kConverged)
      postures[k] = branches.front().q;
  });
  Reached reached;
  for (std::size_t k = 0; k < tubes.size(); ++k) {
    if (postures[k].size() == 0) continue;
    reached.tubes.push_back(tubes[k]);
    reached.postures.push_back(postures[k]);
  }
  return reached;
}

double inUnit(double metres, const Units& units) { return rounded(metres / units.factor(dimension::kLength)); }

nlohmann::json bandJson(const ForecastFigure& figure, const Units& units) {
  return {inUnit(figure.lower, units), inUnit(figure.upper, units)};
}

std::string figureText(const char* name, const ForecastFigure& figure, const Units& units) {
  const double unit = units.factor(dimension::kLength);
  return fmt::format("{} {:.3g} ({:.3g} to {:.3g})", name, figure.value / unit, figure.lower / unit,
                     figure.upper / unit);
}

}  // namespace

PredictedCentring predictCentring(const Cell& cell, const calibration::Identification& fit, bool is_staged,
                                  const calibration::StopQuestion& stop) {
  PredictedCentring predicted;
  predicted.later_stage = is_staged;
  if (!cell.sheet)
    predicted.reason = "the cell has no tube sheet";
  else if (!cell.tool_axis_told)
    predicted.reason = "the cell does not say which way the tool enters a hole";
  else if (fit.status != calibration::IdentificationStatus::kDone)
    predicted.reason = "nothing was identified";
  if (!predicted.reason.empty()) return predicted;
  const auto tubes = holesToLookAt(cell);
  const Reached reached = reach(cell, fit.fitted, tubes, stop);
  predicted.on_sheet = static_cast<int>(cell.sheet->tubes.size());
  predicted.holes = static_cast<int>(reached.tubes.size());
  predicted.out_of_reach = static_cast<int>(tubes.size()) - predicted.holes;
  calibration::CentringForecastOptions options;
  options.base_covariance = cell.base_covariance;
  predicted.forecast = calibration::forecastCentring(fit, reached.postures, options);
  predicted.reason =
      reached.postures.empty() ? "the arm reaches no hole that was looked at" : predicted.forecast.reason;
  if (predicted.forecast.status != CentringForecastStatus::kDone) return predicted;
  const auto worst = static_cast<std::size_t>(predicted.forecast.worst_posture);
  const auto& tube = cell.sheet->tubes[static_cast<std::size_t>(reached.tubes[worst])];
  predicted.worst_hole = tubesheets::tubeName(tube.row, tube.column);
  return predicted;
}

nlohmann::json predictedCentringJson(const PredictedCentring& predicted, const Units& units) {
  if (!predicted.reason.empty()) return {{"reason", predicted.reason}};
  const auto& forecast = predicted.forecast;
  return {{"median", inUnit(forecast.median.value, units)},
          {"p95", inUnit(forecast.p95.value, units)},
          {"worst", {{"value", inUnit(forecast.worst.value, units)}, {"hole", predicted.worst_hole}}},
          {"band",
           {{"level", 0.95},
            {"median", bandJson(forecast.median, units)},
            {"p95", bandJson(forecast.p95, units)},
            {"worst", bandJson(forecast.worst, units)}}},
          {"encoder_noise",
           {{"median", inUnit(forecast.encoders.median, units)},
            {"p95", inUnit(forecast.encoders.p95, units)},
            {"worst", inUnit(forecast.encoders.worst, units)}}},
          {"unit", std::string(units.length().name)},
          {"holes", predicted.holes},
          {"holes_out_of_reach", predicted.out_of_reach},
          {"holes_on_sheet", predicted.on_sheet},
          {"sampled", predicted.holes + predicted.out_of_reach < predicted.on_sheet},
          {"uncertain_numbers", forecast.numbers},
          {"earlier_stages_exact", predicted.later_stage}};
}

std::string predictedCentringText(const PredictedCentring& predicted, const Units& units) {
  if (predicted.on_sheet == 0) return "";
  if (!predicted.reason.empty()) return "predicted centring error: none, since " + predicted.reason + "\n";
  const auto& forecast = predicted.forecast;
  const double unit = units.factor(dimension::kLength);
  std::string text = fmt::format(
      "predicted centring error over {} of {} holes, by what the readings leave open, {} (95 % of the time):\n"
      "  {}, {}, {} near {}\n",
      predicted.holes, predicted.on_sheet, units.length().name,
      figureText("half of the holes within", forecast.median, units), figureText("95 % within", forecast.p95, units),
      figureText("all within", forecast.worst, units), predicted.worst_hole);
  text += fmt::format("  and at each visit the encoders' noise: rms {:.3g} in the median, {:.3g} at worst\n",
                      forecast.encoders.median / unit, forecast.encoders.worst / unit);
  if (predicted.out_of_reach > 0)
    text += fmt::format("  {} of the holes looked for are out of reach\n", predicted.out_of_reach);
  if (predicted.later_stage) text += "  numbers found in earlier stages count as exact here\n";
  return text;
}

}  // namespace tubeplan::app
