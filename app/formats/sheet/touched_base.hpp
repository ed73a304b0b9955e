// Reader and writer of `touched` in a cell's file: the touches that determined the cell's base pose.
#pragma once

#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Reads `touched: {readings: |, numbers: [...], values: [...]}`: a measurement table of the touches, and those
/// parameters of the arm whose fitted values differ from the arm's file. Sets the fitted values in the cell's arm;
/// `cell.placed_by` keeps the arm of the file. The cell must already have its arm, effects and sheet. Throws InputError
/// for any other value.
void readTouched(const YamlNode& node, Cell& cell);

/// Returns the cell's text with the touches, and with the parameters of `arm` that differ from the cell's filed arm.
[[nodiscard]] std::string withTouched(const std::string& text, const Cell& cell,
                                      const std::vector<calibration::Measurement>& touches, const deflection::Arm& arm);

/// Returns the cell's text without the key `touched`, for a base pose from another source.
[[nodiscard]] std::string withoutTouched(const std::string& text);

/// Removes the touches from a cell before a new calibration: resets the arm to its filed parameters and keeps the base.
void forgetTouches(CellModel& cell);

}  // namespace tubeplan::app
