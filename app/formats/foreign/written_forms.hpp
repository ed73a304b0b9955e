// Forms in which other programs write orientations and positions: an open table, with one row for each form.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/formats/units.hpp"

namespace tubeplan::app {

enum class Stated { kTurn, kPlace };

/// Columns of a measurement table for an orientation or a position.
struct StatedColumns {
  const char* word;    ///< name in messages
  const char* option;  ///< option that chooses the form
  std::array<const char*, 3> columns;
  UnitKind unit;
};
[[nodiscard]] const StatedColumns& columnsOf(Stated stated);

/// Numbers of one row in internal units; the fourth is used by quaternions only.
using FormNumbers = std::array<double, 4>;

/// Plausibility of numbers in a form.
enum class FormFit { kUsual, kUnusual, kImpossible };

struct FormNumber {
  const char* name;
  std::optional<UnitKind> unit;
};

struct FormHeadings {
  std::vector<std::string> names;  ///< heading of each number, as parseHeading() returns names
  std::string beside = {};         ///< heading of another column of the table that indicates this form; may be empty
};

/// Form of an orientation or a position. Forms with the same headings are distinguished by their numbers, by other
/// columns, or by the user.
struct WrittenForm {
  const char* name;
  const char* words;  ///< description, and programs that write it
  Stated stated;
  std::vector<FormNumber> numbers;
  std::vector<FormHeadings> headings;
  Eigen::Vector3d (*read)(const FormNumbers& numbers);  ///< returns roll, pitch, yaw [rad], or x, y, z [m]
  FormFit (*fit)(const FormNumbers& numbers);
  const char* usual;  ///< rule for its numbers, as a clause after its name
};

[[nodiscard]] std::span<const WrittenForm> writtenForms();

/// Returns the names of the forms of an orientation or a position, for options.
[[nodiscard]] std::vector<std::string> formNames(Stated stated);

}  // namespace tubeplan::app
