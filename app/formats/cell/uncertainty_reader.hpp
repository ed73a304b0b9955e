// Uncertainty of the arm's numbers: reader and writer of a cell's `uncertainty`.
#pragma once

#include <string>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/estimation/arm_uncertainty.hpp"

namespace tubeplan::app {

/// Reads `uncertainty: {stiffness: 0.1, weight: 0.02, zero: 0.04, axis: 0.02, length: 0.015, tip: 0.02, determined:
/// {numbers: [...], sigma: [...], correlation: [[...], ...]}}`, or `none`. Parts left out have their defaults. Shares
/// are plain numbers; all else is in the cell's units. Throws InputError for anything else.
[[nodiscard]] calibration::ArmUncertainty readUncertainty(const YamlNode& node, const Cell& cell);

/// Returns the text of the whole value, in the units of the arm's cell.
[[nodiscard]] std::string uncertaintyText(const calibration::ArmUncertainty& uncertainty, const deflection::Arm& arm,
                                          const Units& units);

/// Returns the uncertainty without the numbers of effects that the arm no longer has.
[[nodiscard]] calibration::ArmUncertainty knownOf(calibration::ArmUncertainty uncertainty, const deflection::Arm& arm);

}  // namespace tubeplan::app
