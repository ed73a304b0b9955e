// A law written by a user: TARGET += EXPRESSION, such as `theta3 += c*sin(3*theta1)`.
// Start values may follow: `; c=0.1, k=3`.
//
// Targets: a joint (its true value), tip.x, tip.y, tip.z (a shift of the tip along the last row's axes, as in
//      tool-offset), base.x, base.y, base.z, base.yaw (a shift and a rotation of the base, as in base-slip).
// Symbols: a joint's name (its reading: an angle in radians, or a length if the joint is prismatic), JOINT_dir (the
//      direction of the joint's last motion: -1, 0 or 1), moment_ROW_x, _y, _z (moment about the axes of a row of the
//      undeflected arm, under its weights and the hung load), load, and the conditions by their names. In names,
//      characters other than letters and digits become _. If a measurement does not state a condition, the arm's
//      reference value is used.
// Values of symbols that are lengths, forces, moments or conditions are in the file's units. The value of the
// expression is in the target's unit, in degrees for an angle if the file uses degrees.
// All other names are parameters, of two kinds. Sizes are the largest set of parameters in which the formula is linear
// and that make it vanish if they are all zero: they start at 0 and have the target's unit. All others are shapes:
// plain numbers that need a start value.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/effects/effect.hpp"
#include "deflection/effects/expression.hpp"

namespace tubeplan::deflection {

/// Unit of a condition's value in a file: the internal value is (number + zero) * unit.
struct ConditionScale {
  double unit = 1, zero = 0;
};

/// Units of a file, expressed in internal units.
struct FormulaUnits {
  double length = 1, angle = 1, force = 1;
  OfEachCondition<ConditionScale> conditions{};
};

struct FormulaTarget {
  enum class Of { kJoint, kTip, kBase };
  Of of = Of::kJoint;
  int row = -1;   ///< row of the joint; -1 if the target is not a joint
  int axis = -1;  ///< axis of tip or base: 0, 1, 2; 3: yaw; -1 if none
};

/// Meaning of a name in an expression. The value of the name is (internal value) / `unit` - `zero`.
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

/// Returns every symbol that an expression for an arm may name.
[[nodiscard]] std::vector<NamedSymbol> formulaSymbols(const Arm& arm, const FormulaUnits& units);

/// Returns the targets of an arm as written in formulas.
[[nodiscard]] std::vector<std::string> formulaTargets(const Arm& arm);

/// A parsed formula. It never changes, and all effects with this formula share it.
struct Formula {
  std::string text;  ///< the formula as the user wrote it
  /// Place of the effect: the target's name, with "#2" appended for the second formula of a target, and so on.
  std::string at;
  FormulaTarget target;
  Quantity quantity = Quantity::kAngle;  ///< quantity of the target: an angle or a length
  double unit = 1;                       ///< internal units of the target per unit of the expression's value

  /// Meaning of one name in the expression: the parameter with index `parameter` or, if that is -1, `symbol`.
  struct Input {
    int parameter = -1;
    FormulaSymbol symbol;
  };
  std::vector<Input> inputs;
  std::shared_ptr<const Expression> expression;

  std::vector<std::string> names;           ///< names of the parameters
  std::vector<EffectParameter> parameters;  ///< the parameters; `name` of each points into `names`
  std::vector<double> units;                ///< internal units per unit of the expression, for each parameter

  Formula() = default;
  Formula(const Formula&) = delete;
  Formula& operator=(const Formula&) = delete;
};

enum class FormulaStatus { kNotRun, kMade, kBadTarget, kBadExpression, kBadStart, kNeedsStart };

struct MadeFormula {
  FormulaStatus status = FormulaStatus::kNotRun;
  /// Reason for failure: the wrong value found or, if `expected` is empty, a sentence that describes the problem.
  std::string found;
  std::string expected;            ///< description of valid values; empty unless a value is wrong
  std::string word;                ///< the unknown name; empty for other errors
  std::vector<std::string> known;  ///< valid names, if a name is unknown
  /// Parameters without a start value; a misspelt symbol shows up here.
  std::vector<std::string> free;
  Effect effect;  ///< the effect at its start values
};

/// Parses a formula for an arm. `at` is the effect's place as stated in a file. If `at` is empty, the place is the
/// target's name, with "#2", "#3", ... appended if it is taken.
[[nodiscard]] MadeFormula makeFormula(const Arm& arm, std::string_view text, const FormulaUnits& units,
                                      std::string_view at = "");

/// Returns a sentence about the first formula of an arm that lacks a finite value, or a finite derivative with respect
/// to one of its symbols or parameters, at a posture. Empty if there is none.
[[nodiscard]] std::string findUndefinedFormula(const Arm& arm, const Posture& posture);

}  // namespace tubeplan::deflection
