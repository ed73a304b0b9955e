// Every number of an arm under its dotted name, for any scalar: the parameters of identification and the variables of
// derivatives.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/arm.hpp"
#include "deflection/quantity.hpp"

namespace tubeplan::deflection {

/// Location of a parameter: `row` -1 is the tool; `field` indexes parameterFields(); `lump` counts the row's lumps. A
/// number of an effect has only the effect's index in the arm and the value's index in the effect.
struct ParameterPath {
  int row = -1;
  int field = -1;
  int lump = -1;
  int effect = -1;
  int value = -1;
  int side_chain = -1;  ///< side chain of the row; -1 for the arm's own rows
  bool operator==(const ParameterPath&) const = default;
};

/// A kind of number that rows (or the tool) can have and that can be identified: those of row_numbers.hpp.
struct ParameterField {
  std::string_view name;  ///< name within the row: "joint_stiffness.z"
  Quantity quantity;
  double lower, upper;  ///< physical bounds in internal units
  bool of_tool, of_lump;
};

const std::vector<ParameterField>& parameterFields();

/// Returns a row's number of that kind, or null if the row has none.
double* findNumber(Row<double>& row, const ParameterField& field, int lump);
Dual* findNumber(Row<Dual>& row, const ParameterField& field, int lump);

struct Parameter {
  std::string name;  ///< dotted path in the arm file: "tool.joint_stiffness.z", "tool.tip.x", "backlash@tool.z.gap"
  Quantity quantity = Quantity::kNone;
  ParameterPath path;
  double value = 0;
  double lower = 0, upper = 0;
};

/// Returns all finite numbers of the arm, in file order, then those of its effects; rigid axes are left out.
std::vector<Parameter> parametersOf(const Arm& arm);

/// Returns the parameter of that dotted name, or nothing.
std::optional<Parameter> findParameter(const Arm& arm, std::string_view name);

/// Returns the number itself; the path must be one of parametersOf() for an arm of the same structure.
double& locate(Arm& arm, const ParameterPath& path);
Dual& locate(ArmOf<Dual>& arm, const ParameterPath& path);

/// Returns the arm in another scalar (derivatives zero, or dropped).
template <class To, class From>
ArmOf<To> castArm(const ArmOf<From>& arm);

}  // namespace tubeplan::deflection
