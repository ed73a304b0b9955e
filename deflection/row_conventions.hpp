// One arm by rows of another convention: origins, Denavit-Hartenberg numbers as Craig modified them, or the standard
// ones.
//
// Denavit-Hartenberg frames stand where the common normal of an axis and the next one is. Where two axes are nearly
// parallel that may be anywhere; there the next origin is put across from the one before, in the plane at right angles
// to the axis before, and a tilt beta about y makes up for it (Hayati and Mirmirani 1985, "Improving the absolute
// positioning accuracy of robot manipulators", J. Robotic Systems 2).
#pragma once

#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

enum class RowConvention {
  kModified,  ///< as DenavitHartenberg has it: alpha and a lead to the row's own axis
  kStandard,  ///< RotZ(theta) TransZ(d) TransX(a) RotX(alpha) RotY(beta): the last three lead on to the next row's axis
  kOrigin,    ///< as Origin has it
};

/// The conventions by their names in files, in the order of RowConvention.
[[nodiscard]] std::span<const std::string_view> rowConventionNames();

struct ConversionOptions {
  /// rad; axes within it of parallel, or of opposite, take a beta. By zero all have a common normal, however far off.
  double nearly_parallel = 5 * std::numbers::pi / 180;
};

struct ConvertedArm {
  bool is_converted = false;
  std::string row, reason;  ///< which row cannot be written so and why, where it is not
  Arm arm;                  ///< the same tip, axes and loads, without effects
};

/// Rows of that convention for the same arm: frames are slid along their axes and turned about them as it asks for, a
/// row without a joint is put first where the base's own frame would have to be. A row whose stiffness, beam or weight
/// would be another in such a frame is refused.
[[nodiscard]] ConvertedArm convertRows(const Arm& arm, RowConvention convention, const ConversionOptions& options = {});

/// Rows whose Denavit-Hartenberg numbers are the standard ones, each its own, become Craig's, which have alpha, a and
/// beta of the row before; the names of parameters stay those of the file (Row::placed_by). Where the last row has any
/// of the three, a row NAME-end without a joint has them. Rows by origin, if any, come first.
void readAsStandard(std::vector<Row<double>>& rows);

/// Whether rows are such.
[[nodiscard]] bool isStandard(const std::vector<Row<double>>& rows);

/// The numbers that the k-th of such rows has in its file.
[[nodiscard]] DenavitHartenberg<double> standardNumbers(const std::vector<Row<double>>& rows, std::size_t k);

}  // namespace tubeplan::deflection
