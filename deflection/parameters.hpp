// Access to every numeric value of an arm by its dotted name, for any scalar type. Fits estimate these values, and the
// tip can be differentiated with respect to them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/arm.hpp"
#include "deflection/quantity.hpp"

namespace tubeplan::deflection {

/// Location of a parameter. `row` is -1 for the tool, `field` an index into parameterFields(), `lump` an index among
/// the row's lumps. A parameter of an effect has only `effect`, the index in the arm, and `value`, the index in the
/// effect.
struct ParameterPath {
  int row = -1;
  int field = -1;
  int lump = -1;
  int effect = -1;
  int value = -1;
  int side_chain = -1;  ///< index of the side chain that `row` belongs to; -1 means a row of the arm itself
  bool operator==(const ParameterPath&) const = default;
};

/// A kind of parameter that fits can estimate: a value of a row, from the list in row_numbers.hpp, or of the tool.
struct ParameterField {
  std::string_view name;  ///< name within the row, such as "joint_stiffness.z"
  Quantity quantity;
  double lower, upper;  ///< physical bounds in internal units
  bool of_tool, of_lump;
};

const std::vector<ParameterField>& parameterFields();

/// Returns a pointer to the value of a row that `field` describes; null if the row has no such value.
double* findNumber(Row<double>& row, const ParameterField& field, int lump);
Dual* findNumber(Row<Dual>& row, const ParameterField& field, int lump);

struct Parameter {
  std::string name;  ///< dotted path in the arm file, such as "tool.joint_stiffness.z" or "backlash@tool.z.gap"
  Quantity quantity = Quantity::kNone;
  ParameterPath path;
  double value = 0;
  double lower = 0, upper = 0;
};

/// Returns all finite values of the arm as parameters, in file order, followed by the parameters of its effects. The
/// infinite stiffness of a rigid axis is not a parameter.
std::vector<Parameter> parametersOf(const Arm& arm);

/// Returns the parameter named `name`; std::nullopt if there is none.
std::optional<Parameter> findParameter(const Arm& arm, std::string_view name);

/// Returns the value of a parameter, by reference. `path` must come from parametersOf() for an arm of the same
/// structure.
double& locate(Arm& arm, const ParameterPath& path);
Dual& locate(ArmOf<Dual>& arm, const ParameterPath& path);

/// Converts an arm to another scalar type. Derivatives are dropped; the derivatives of the new type are zero.
template <class To, class From>
ArmOf<To> castArm(const ArmOf<From>& arm);

}  // namespace tubeplan::deflection
