// Touches that placed a cell's base, in the cell's file: `touched`, beside `base`.
#pragma once

#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Reads `touched: {readings: |, numbers: [...], values: [...]}`: a measurement table of the touches, and the arm's
/// numbers whose values fitted to the touches differ from the arm's file. Sets these values in the cell's arm;
/// placed_by keeps the arm as filed. Requires the arm, its effects and the sheet of the cell. Throws InputError for
/// anything else.
void readTouched(const YamlNode& node, Cell& cell);

/// Returns the text with the touches and the numbers in which `arm` differs from the cell's filed arm.
[[nodiscard]] std::string withTouched(const std::string& text, const Cell& cell,
                                      const std::vector<calibration::Measurement>& touches, const deflection::Arm& arm);

/// Returns the text without `touched`, for a base from another source.
[[nodiscard]] std::string withoutTouched(const std::string& text);

/// Removes the touches from a cell for a new calibration: its arm is as filed again, the base stays.
void forgetTouches(CellModel& cell);

}  // namespace tubeplan::app
