// Conversion of an arm to rows of another convention: origins, Denavit-Hartenberg numbers as Craig modified them, or
// the standard ones.
//
// Denavit-Hartenberg frames stand where the common normal of an axis and the next one is. Where two axes are nearly
// parallel that may be anywhere. There the next origin is put opposite the one before, in the plane at right angles to
// the axis before, and a rotation beta about y completes the placement (Hayati and Mirmirani 1985, "Improving the
// absolute positioning accuracy of robot manipulators", J. Robotic Systems 2).
#pragma once

#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

enum class RowConvention {
  kModified,  ///< numbers of DenavitHartenberg: alpha and a lead to the row's own axis
  kStandard,  ///< RotZ(theta) TransZ(d) TransX(a) RotX(alpha) RotY(beta): the last three lead to the next row's axis
  kOrigin,    ///< numbers of Origin
};

/// Returns the conventions' names in files, in the order of RowConvention.
[[nodiscard]] std::span<const std::string_view> rowConventionNames();

struct ConversionOptions {
  /// angle within which axes count as parallel or opposite, and take a beta [rad]; at zero all use a common normal,
  /// however far away
  double nearly_parallel = 5 * std::numbers::pi / 180;
};

struct ConvertedArm {
  bool is_converted = false;
  std::string row, reason;  ///< row that cannot be converted, and why
  Arm arm;                  ///< the arm with the same tip, axes and loads, without effects
};

/// Converts the rows of an arm. Frames are moved along their axes and turned about them as the convention requires; a
/// row without a joint is put first if the base's own frame would have to move. A row whose stiffness, beam or weight
/// would change in such a frame is refused.
[[nodiscard]] ConvertedArm convertRows(const Arm& arm, RowConvention convention, const ConversionOptions& options = {});

/// Rows whose Denavit-Hartenberg numbers are the standard ones, each its own, become Craig's, which have alpha, a and
/// beta of the row before; the names of parameters stay those of the file (Row::placed_by). Where the last row has any
/// of the three, a row NAME-end without a joint has them. Rows by origin, if any, come first; a first row by these
/// numbers has its axis at the base's z, and may be led elsewhere by its own alpha, a, beta and b as Craig's row.
void readAsStandard(std::vector<Row<double>>& rows);

/// Returns true if rows were converted by readAsStandard().
[[nodiscard]] bool isStandard(const std::vector<Row<double>>& rows);

/// Returns the numbers of the k-th of such rows in its file.
[[nodiscard]] DenavitHartenberg<double> standardNumbers(const std::vector<Row<double>>& rows, std::size_t k);

}  // namespace tubeplan::deflection
