// Effects of a cell's arm beyond its file: additions after a diagnosis, or hidden ones for practice.
//
//   effects:
//     - {effect: backlash, at: tool.z, gap: 0.12}
//     - {effect: formula, at: theta3, formula: "theta3 += c*sin(3*theta1)", c: 0.02}
//
// Numbers have the units of the cell; missing ones are neutral.
#pragma once

#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"
#include "deflection/effects/effect.hpp"
#include "deflection/effects/formula.hpp"

namespace tubeplan::app {

/// Reads the list of effects. Throws InputError for an unknown effect, place or number, a duplicate, or a number out of
/// its bounds.
[[nodiscard]] std::vector<deflection::Effect> readEffects(const YamlNode& node, const deflection::Arm& arm,
                                                          const Units& units);

/// Returns an effect with its numbers in the syntax of parseEffect: "base-slip@base:time=5400,x=0.02".
[[nodiscard]] std::string effectText(const deflection::Arm& arm, const deflection::Effect& effect, const Units& units);

/// Returns the arm's effects as a list in flow style, in the syntax of readEffects.
[[nodiscard]] std::string effectsText(const deflection::Arm& arm, const Units& units);

/// Returns a cell's units for use in formulas.
[[nodiscard]] deflection::FormulaUnits formulaUnitsOf(const Units& units);

/// Parses a formula of the command line, 'theta3 += c*sin(3*theta1)', for an arm with its other effects; `at` is the
/// place asked for, or empty. Throws InputError, with the argument `where`, also for a parameter without initial value
/// that looks like a misspelt symbol.
[[nodiscard]] deflection::Effect parseFormula(const std::string& text, const deflection::Arm& arm, const Units& units,
                                              const std::string& where, const std::string& at = "");

/// Returns a line on the units of a formula's numbers in a cell.
[[nodiscard]] std::string formulaUnitsText(const deflection::Arm& arm, const deflection::Effect& formula,
                                           const Units& units);

/// Effect of the command line: a formula, "backlash@tool.z", "backlash@tool.z:0.15deg" (its first number), or
/// "stiffening@tool.z:softness=0.6,knee=200" (by name, in the cell's units, which a stated unit must match).
/// parseEffect() throws InputError, with the argument `where`.
struct ParsedEffect {
  deflection::Effect effect;
  bool has_sizes = false;
};
[[nodiscard]] ParsedEffect parseEffect(const std::string& text, const deflection::Arm& arm, const Units& units,
                                       const std::string& where);

}  // namespace tubeplan::app
