// Forms in which other programs write orientations and positions: a table with one row for each form.
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

/// Columns of a measurement table that state an orientation or a position.
struct StatedColumns {
  const char* word;    ///< name of the quantity in messages
  const char* option;  ///< command-line option that chooses the form
  std::array<const char*, 3> columns;
  UnitKind unit;
};
[[nodiscard]] const StatedColumns& columnsOf(Stated stated);

/// Numbers of a form in one row, in internal units; only quaternions use the fourth number.
using FormNumbers = std::array<double, 4>;

/// Plausibility of a row's numbers if they are read in a certain form.
enum class FormFit { kUsual, kUnusual, kImpossible };

struct FormNumber {
  const char* name;
  std::optional<UnitKind> unit;
};

struct FormHeadings {
  std::vector<std::string> names;  ///< heading of each number, in the notation of parseHeading()
  std::string indicator = {};      ///< heading of a further column that indicates this form; may be empty
  const char* taken = "";          ///< order of the numbers, if the headings do not state it: "w first"
};

/// Form of an orientation or a position. Forms with the same headings are distinguished by their numbers, by further
/// columns, or by the user.
struct WrittenForm {
  const char* name;
  const char* words;  ///< description of the form, and programs that write it
  Stated stated;
  std::vector<FormNumber> numbers;
  std::vector<FormHeadings> headings;
  Eigen::Vector3d (*read)(const FormNumbers& numbers);  ///< converts to roll, pitch, yaw [rad], or to x, y, z [m]
  FormFit (*fit)(const FormNumbers& numbers);
  const char* usual;  ///< rule for the form's numbers, as a clause that follows the form's name
};

[[nodiscard]] std::span<const WrittenForm> writtenForms();

/// Returns the names of all forms of an orientation or a position, for command-line options.
[[nodiscard]] std::vector<std::string> formNames(Stated stated);

}  // namespace tubeplan::app
