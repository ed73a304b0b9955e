// How well the arm's numbers are known: a cell's `uncertainty`, read and written.
#pragma once

#include <string>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/estimation/arm_uncertainty.hpp"

namespace tubeplan::app {

/// `uncertainty: {stiffness: 0.1, weight: 0.02, zero: 0.04, axis: 0.02, length: 0.015, tip: 0.02, determined: {numbers:
/// [...], sigma: [...], correlation: [[...], ...]}}`, each part where it differs from the default, or `none`. Shares
/// are plain numbers; all else is in the cell's units. Throws InputError for anything else.
[[nodiscard]] calibration::ArmUncertainty readUncertainty(const YamlNode& node, const Cell& cell);

/// The text of the whole value, in the units of a cell whose arm this is.
[[nodiscard]] std::string uncertaintyText(const calibration::ArmUncertainty& uncertainty, const deflection::Arm& arm,
                                          const Units& units);

/// Returns what is known of the numbers that an arm has, without those of effects that were taken off it.
[[nodiscard]] calibration::ArmUncertainty knownOf(calibration::ArmUncertainty uncertainty, const deflection::Arm& arm);

}  // namespace tubeplan::app
