// Conversion of an arm's rows to another convention: origins, Denavit-Hartenberg parameters as modified by Craig, or
// standard Denavit-Hartenberg parameters.
//
// The origin of a Denavit-Hartenberg frame lies on the common normal of its axis and the next axis. For two nearly
// parallel axes, that normal may be anywhere. In that case the next origin is put opposite the current origin, in the
// plane perpendicular to the current axis, and a rotation beta about y completes the placement (Hayati and Mirmirani
// 1985, "Improving the absolute positioning accuracy of robot manipulators", J. Robotic Systems 2).
#pragma once

#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

enum class RowConvention {
  kModified,  ///< parameters of DenavitHartenberg: alpha and a lead to the row's own axis
  kStandard,  ///< RotZ(theta) TransZ(d) TransX(a) RotX(alpha) RotY(beta): the last three lead to the next row's axis
  kOrigin,    ///< parameters of Origin
};

/// Returns the names of the conventions in files, in the order of RowConvention.
[[nodiscard]] std::span<const std::string_view> rowConventionNames();

struct ConversionOptions {
  /// Angle between two axes [rad] below which they are treated as parallel or antiparallel; the row then gets a beta.
  /// If zero, every row uses the common normal, even if it is far away.
  double nearly_parallel = 5 * std::numbers::pi / 180;
};

struct ConvertedArm {
  bool is_converted = false;
  std::string row, reason;  ///< row that cannot be converted, and the reason
  Arm arm;                  ///< the arm with the same tip, axes and loads, without effects
};

/// Converts the rows of an arm to `convention`. Frames are moved along their axes and rotated about them as the
/// convention requires. A row without a joint is inserted first if the base's own frame would have to move. The
/// conversion fails if moving a row's frame would change its stiffness, beam or weight.
[[nodiscard]] ConvertedArm convertRows(const Arm& arm, RowConvention convention, const ConversionOptions& options = {});

/// Converts rows with standard Denavit-Hartenberg parameters to Craig's convention, in which each row takes over alpha,
/// a and beta of the row before. The parameters keep the names of the file (Row::placed_by). If the last row has a
/// non-zero alpha, a or beta, a row NAME-end without a joint is added to hold them. Rows placed by origin, if any, must
/// come first. The axis of a first row with standard parameters is the base's z axis; the row's alpha, a, beta and b in
/// Craig's convention can place it elsewhere.
void readAsStandard(std::vector<Row<double>>& rows);

/// Returns true if rows were converted by readAsStandard().
[[nodiscard]] bool isStandard(const std::vector<Row<double>>& rows);

/// Returns the standard parameters, as in the file, of the k-th row converted by readAsStandard().
[[nodiscard]] DenavitHartenberg<double> standardNumbers(const std::vector<Row<double>>& rows, std::size_t k);

}  // namespace tubeplan::deflection
