// The touches that placed a cell's base, in its file: `touched`, beside `base`.
#pragma once

#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// `touched: {readings: |, numbers: [...], values: [...]}`: a measurement table of the touches, and the arm's numbers
/// that they give other values than the arm's file. The cell's arm takes those values; placed_by keeps the arm as
/// filed. The arm, its effects and the sheet must have been read. Throws InputError for anything else.
void readTouched(const YamlNode& node, Cell& cell);

/// The text with the touches and the numbers in which `arm` differs from the cell's filed arm.
[[nodiscard]] std::string withTouched(const std::string& text, const Cell& cell,
                                      const std::vector<calibration::Measurement>& touches, const deflection::Arm& arm);

/// The text without them, for a base that was found otherwise.
[[nodiscard]] std::string withoutTouched(const std::string& text);

/// The cell before anything was touched, to be calibrated anew: its arm as filed, the base where it is.
void forgetTouches(CellModel& cell);

}  // namespace tubeplan::app
