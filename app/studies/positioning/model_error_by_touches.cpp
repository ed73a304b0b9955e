#include "app/studies/positioning/model_error_by_touches.hpp"

#include "app/studies/positioning/spread_postures.hpp"
#include "app/studies/positioning/step_chances.hpp"
#include "calibration/forecast/tip_error.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kWorkHoles = 40;

}  // namespace

std::optional<ModelError> modelErrorOf(const CellModel& cell, const calibration::BaseCalibration& base,
                                       const std::vector<calibration::Measurement>& touches) {
  if (base.status != calibration::CalibrationStatus::kDone || isFoundElsewhere(cell.model_error)) return std::nullopt;
  const double load = touches.front().load;
  const calibration::TipErrorQuestion asked{cell.arm,
                                            base.X_WB,
                                            load,
                                            touches,
                                            base.covariance,
                                            std::nullopt,
                                            spreadPostures(cell, cell.arm, base.X_WB, kWorkHoles).postures};
  return modelErrorByTouches(calibration::findTipError(asked), touches.size());
}

}  // namespace tubeplan::app
