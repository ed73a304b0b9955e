// Effects of a cell's arm that the arm file does not contain: added after a diagnosis, or hidden in simulated
// measurements.
//
//   effects:
//     - {effect: backlash, at: tool.z, gap: 0.12}
//     - {effect: formula, at: theta3, formula: "theta3 += c*sin(3*theta1)", c: 0.02}
//
// Parameters have the units of the cell; a missing parameter has its neutral value.
#pragma once

#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"
#include "app/storage/input_error.hpp"
#include "deflection/effects/effect.hpp"
#include "deflection/effects/formula.hpp"

namespace tubeplan::app {

/// Reads the list of effects. Throws InputError for an unknown effect, place or parameter, a duplicate effect, or a
/// parameter out of bounds.
[[nodiscard]] std::vector<deflection::Effect> readEffects(const YamlNode& node, const deflection::Arm& arm,
                                                          const Units& units);

/// Returns an effect with its parameters in the syntax of parseEffect(): "base-slip@base:time=5400,x=0.02".
[[nodiscard]] std::string effectText(const deflection::Arm& arm, const deflection::Effect& effect, const Units& units);

/// Returns the arm's effects as a YAML list in flow style, in the syntax of readEffects().
[[nodiscard]] std::string effectsText(const deflection::Arm& arm, const Units& units);

/// Returns the units in which formulas of a cell are evaluated.
[[nodiscard]] deflection::FormulaUnits formulaUnitsOf(const Units& units);

/// Parses a formula from the command line, such as 'theta3 += c*sin(3*theta1)', for an arm that may have other effects.
/// `at` is the requested place on the arm, or empty. Throws InputError, naming the argument as `where`, for an invalid
/// formula and for a parameter without initial value that looks like a misspelt symbol.
[[nodiscard]] deflection::Effect parseFormula(const std::string& text, const deflection::Arm& arm, const Units& units,
                                              const std::string& where, const std::string& at = "");

/// Returns a sentence that states the units of a formula's symbols and value in a cell.
[[nodiscard]] std::string formulaUnitsText(const deflection::Arm& arm, const deflection::Effect& formula,
                                           const Units& units);

/// Returns the error for an effect `name` that cannot be at the place `at`; `made` is the result of the attempt. The
/// message lists the possible places. `where` names the key or the argument.
[[nodiscard]] InputError placeError(const std::string& where, const deflection::MadeEffect& made,
                                    const std::string& name, const std::string& at);

/// Effect from the command line: a formula, "backlash@tool.z", "backlash@tool.z:0.15deg" (value of its first
/// parameter), or "stiffening@tool.z:softness=0.6,knee=200" (values by name). Values are in the cell's units; a stated
/// unit must agree. parseEffect() throws InputError, naming the argument as `where`.
struct ParsedEffect {
  deflection::Effect effect;
  bool has_sizes = false;
};
[[nodiscard]] ParsedEffect parseEffect(const std::string& text, const deflection::Arm& arm, const Units& units,
                                       const std::string& where);

}  // namespace tubeplan::app
