// The forms in which other programs write turns and places: an open table. A new one is a row of it.
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

/// The columns of a measurement table that a turn or a place becomes.
struct StatedColumns {
  const char* word;    ///< for messages
  const char* option;  ///< of the form's name
  std::array<const char*, 3> columns;
  UnitKind unit;
};
[[nodiscard]] const StatedColumns& columnsOf(Stated stated);

/// Numbers of one row in internal units; the last of four counts in quaternions alone.
using FormNumbers = std::array<double, 4>;

/// How likely a program is to write certain numbers in a form.
enum class FormFit { kUsual, kUnusual, kImpossible };

struct FormNumber {
  const char* name;
  std::optional<UnitKind> unit;
};

struct FormHeadings {
  std::vector<std::string> names;  ///< of each number, as parseHeading() gives them
  std::string beside = {};  ///< a column of the same table that decides for this form, where others have the names
};

/// Two forms with the same headings are told apart by their numbers, by what stands beside them, or by the user.
struct WrittenForm {
  const char* name;
  const char* words;  ///< what it is, and who writes it
  Stated stated;
  std::vector<FormNumber> numbers;
  std::vector<FormHeadings> headings;
  Eigen::Vector3d (*read)(const FormNumbers& numbers);  ///< roll, pitch, yaw [rad], or x, y, z [m]
  FormFit (*fit)(const FormNumbers& numbers);
  const char* usual;  ///< what its numbers keep to, as a clause behind its name
};

[[nodiscard]] std::span<const WrittenForm> writtenForms();

/// The names of forms that state it, for options.
[[nodiscard]] std::vector<std::string> formNames(Stated stated);

}  // namespace tubeplan::app
