// The effects a cell's arm has beyond its file: what was added after a diagnosis, or hidden for practice.
//
//   effects:
//     - {effect: backlash, at: tool.z, gap: 0.12}
//     - {effect: formula, at: theta3, formula: "theta3 += c*sin(3*theta1)", c: 0.02}
//
// Numbers have the units of the cell; those left out are neutral.
#pragma once

#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"
#include "deflection/effects/effect.hpp"
#include "deflection/effects/formula.hpp"

namespace tubeplan::app {

/// Throws InputError for an unknown effect, place or number, one twice, or a number out of its bounds.
[[nodiscard]] std::vector<deflection::Effect> readEffects(const YamlNode& node, const deflection::Arm& arm,
                                                          const Units& units);

/// "base-slip@base:time=5400,x=0.02": the effect with its numbers, as parseEffect takes it.
[[nodiscard]] std::string effectText(const deflection::Arm& arm, const deflection::Effect& effect, const Units& units);

/// The list in flow style, as readEffects takes it.
[[nodiscard]] std::string effectsText(const deflection::Arm& arm, const Units& units);

/// A cell's units, as formulas have them.
[[nodiscard]] deflection::FormulaUnits formulaUnitsOf(const Units& units);

/// A formula as on the command line, 'theta3 += c*sin(3*theta1)', for an arm that has its other effects already; `at`
/// is the place asked for, or empty. Throws InputError, `where` naming the argument: also for a parameter that looks
/// like a misspelt symbol and has no start.
[[nodiscard]] deflection::Effect parseFormula(const std::string& text, const deflection::Arm& arm, const Units& units,
                                              const std::string& where, const std::string& at = "");

/// What the numbers of a formula mean in a cell, in one line.
[[nodiscard]] std::string formulaUnitsText(const deflection::Arm& arm, const deflection::Effect& formula,
                                           const Units& units);

/// An effect as on the command line: a formula, "backlash@tool.z", "backlash@tool.z:0.15deg" (its first number),
/// "stiffening@tool.z:softness=0.6,knee=200" (by name, in the cell's units; a unit that is written must be the cell's).
/// Throws InputError, `where` naming the argument.
struct ParsedEffect {
  deflection::Effect effect;
  bool has_sizes = false;
};
[[nodiscard]] ParsedEffect parseEffect(const std::string& text, const deflection::Arm& arm, const Units& units,
                                       const std::string& where);

}  // namespace tubeplan::app
