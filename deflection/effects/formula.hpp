// A law that a user writes: TARGET += EXPRESSION, as `theta3 += c*sin(3*theta1)`; starts may follow: `; c=0.1, k=3`.
//
// Targets: a joint (its true value), tip.x, tip.y, tip.z (the tip shifted along the last row's axes, as tool-offset's),
// base.x, base.y, base.z, base.yaw (the base stands shifted and turned, as base-slip's).
// Symbols: a joint's name (its reading: radians, of a slide a length), JOINT_dir (the sense of its last motion, -1, 0,
// 1), moment_ROW_x, _y, _z (about the axes of a row, of the arm undeflected under its weights and the hung load), load,
// the conditions by their names. In names with other signs than letters and digits those become _. A reading without
// a condition has the arm's reference value of it.
// Numbers are those of the file's units: lengths, forces and conditions among the symbols have them, and the
// expression's value has the target's, an angle's degrees where the file has degrees.
// All other names are parameters. The largest set of them in which the formula is linear, and without which it
// vanishes, are its sizes: they start at 0 and have the target's unit. The others are shapes: plain numbers that need a
// start.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/effects/effect.hpp"
#include "deflection/effects/expression.hpp"

namespace tubeplan::deflection {

/// Unit of a condition's number: the internal value is (number + zero) * unit.
struct ConditionScale {
  double unit = 1, zero = 0;
};

/// Units of a file in internal units.
struct FormulaUnits {
  double length = 1, angle = 1, force = 1;
  OfEachCondition<ConditionScale> conditions{};
};

struct FormulaTarget {
  enum class Of { kJoint, kTip, kBase };
  Of of = Of::kJoint;
  int row = -1;   ///< row of a joint
  int axis = -1;  ///< axis of tip or base: 0, 1, 2; 3: yaw
};

/// Meaning of a name in an expression: (internal value) / unit - zero.
struct FormulaSymbol {
  enum class Of { kJoint, kApproachDirection, kMoment, kLoad, kCondition };
  Of of = Of::kLoad;
  int row = -1, axis = -1;
  double unit = 1, zero = 0;
  Condition condition{};  ///< condition of a kCondition symbol
};

struct NamedSymbol {
  std::string name;
  FormulaSymbol symbol;
};

/// Returns everything that an expression may name for an arm.
[[nodiscard]] std::vector<NamedSymbol> formulaSymbols(const Arm& arm, const FormulaUnits& units);

/// Returns the targets of an arm as they are written.
[[nodiscard]] std::vector<std::string> formulaTargets(const Arm& arm);

/// A parsed formula; shared by the effects that carry it and never changed.
struct Formula {
  std::string text;  ///< text as written
  std::string at;    ///< the target's name; the second formula of a target has "#2" appended, and so on
  FormulaTarget target;
  Quantity quantity = Quantity::kAngle;  ///< quantity of the target: an angle or a length
  double unit = 1;                       ///< internal units of the target per unit of the expression's value

  /// Meaning of one name of the expression: a symbol, or the index of a parameter.
  struct Input {
    int parameter = -1;
    FormulaSymbol symbol;
  };
  std::vector<Input> inputs;
  std::shared_ptr<const Expression> expression;

  std::vector<std::string> names;           ///< names of the parameters
  std::vector<EffectParameter> parameters;  ///< their names point into `names`
  std::vector<double> units;                ///< internal units per number of the expression, for each parameter

  Formula() = default;
  Formula(const Formula&) = delete;
  Formula& operator=(const Formula&) = delete;
};

enum class FormulaStatus { kNotRun, kMade, kBadTarget, kBadExpression, kBadStart, kNeedsStart };

struct MadeFormula {
  FormulaStatus status = FormulaStatus::kNotRun;
  std::string found;               ///< wrong value if not made; without an expected one, a sentence of what is wrong
  std::string expected;            ///< expected value; empty unless a value is wrong
  std::string word;                ///< the unknown name, if that is the reason
  std::vector<std::string> known;  ///< the known names, if one is unknown
  std::vector<std::string> free;   ///< parameters without a start, if made; a misspelt symbol is among them
  Effect effect;                   ///< the effect at its start values
};

/// Parses a formula of an arm. `at` is the effect's place in a file; if empty, it becomes the target with the first
/// free number.
[[nodiscard]] MadeFormula makeFormula(const Arm& arm, std::string_view text, const FormulaUnits& units,
                                      std::string_view at = "");

/// Returns what a formula of an arm lacks at a posture: a finite value, or finite derivatives by joints and its
/// parameters. Empty if nothing.
[[nodiscard]] std::string findUndefinedFormula(const Arm& arm, const Posture& posture);

}  // namespace tubeplan::deflection
