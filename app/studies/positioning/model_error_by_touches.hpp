// What touches of a calibrated base determine of the arm's error beyond its model, where the arm works.
#pragma once

#include <optional>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::app {

/// Nothing where the base was not found, or the cell has the error from elsewhere.
[[nodiscard]] std::optional<ModelError> modelErrorOf(const CellModel& cell, const calibration::BaseCalibration& base,
                                                     const std::vector<calibration::Measurement>& touches);

}  // namespace tubeplan::app
