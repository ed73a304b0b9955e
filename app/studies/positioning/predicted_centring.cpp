#include "app/studies/positioning/predicted_centring.hpp"

#include "app/studies/positioning/spread_postures.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::app {

namespace {

using calibration::CentringForecastStatus;

constexpr std::size_t kHoles = 200;

}  // namespace

PredictedCentring predictCentring(const CellModel& cell, const calibration::Identification& fit, bool is_staged,
                                  const calibration::StopQuestion& stop) {
  PredictedCentring predicted;
  predicted.later_stage = is_staged;
  if (!cell.sheet)
    predicted.reason = "the cell has no tube sheet";
  else if (!cell.tool_axis_stated)
    predicted.reason = "the cell does not state the tool's insertion direction";
  else if (fit.status != calibration::IdentificationStatus::kDone)
    predicted.reason = "nothing was identified";
  if (!predicted.reason.empty()) return predicted;
  const SpreadPostures reached = spreadPostures(cell, fit.fitted.arm, fit.fitted.base_poses.back().X_WB, kHoles, stop);
  predicted.on_sheet = static_cast<int>(cell.sheet->tubes.size());
  predicted.holes = static_cast<int>(reached.tubes.size());
  predicted.out_of_reach = reached.asked - predicted.holes;
  calibration::CentringForecastOptions options;
  options.base_covariance = cell.base_covariance;
  predicted.forecast = calibration::forecastCentring(fit, reached.postures, options);
  predicted.reason = reached.postures.empty() ? "the arm reaches none of the holes" : predicted.forecast.reason;
  if (predicted.forecast.status != CentringForecastStatus::kDone) return predicted;
  const auto worst = static_cast<std::size_t>(predicted.forecast.worst_posture);
  const auto& tube = cell.sheet->tubes[static_cast<std::size_t>(reached.tubes[worst])];
  predicted.worst_hole = tubesheets::tubeName(tube.row, tube.column);
  return predicted;
}

}  // namespace tubeplan::app
