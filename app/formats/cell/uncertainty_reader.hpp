// Uncertainty of the arm's parameters: reader and writer of a cell's `uncertainty`.
#pragma once

#include <string>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/estimation/arm_uncertainty.hpp"

namespace tubeplan::app {

/// Reads `uncertainty: {stiffness: 0.1, weight: 0.02, zero: 0.04, axis: 0.02, length: 0.015, tip: 0.02, determined:
/// {numbers: [...], sigma: [...], correlation: [[...], ...]}}`, or `none`. Missing keys have default values. Fractions
/// are plain numbers; all other values are in the cell's units. Throws InputError for any other value.
[[nodiscard]] calibration::ArmUncertainty readUncertainty(const YamlNode& node, const Cell& cell);

/// Returns the YAML text of the value of `uncertainty`, in the cell's units.
[[nodiscard]] std::string uncertaintyText(const calibration::ArmUncertainty& uncertainty, const deflection::Arm& arm,
                                          const Units& units);

/// Returns the uncertainty without parameters that the arm no longer has, such as those of removed effects.
[[nodiscard]] calibration::ArmUncertainty knownOf(calibration::ArmUncertainty uncertainty, const deflection::Arm& arm);

}  // namespace tubeplan::app
