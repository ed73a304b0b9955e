// Assignment of the columns of foreign tables to the columns of a measurement table.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/foreign/foreign_table.hpp"
#include "app/formats/foreign/written_forms.hpp"
#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Words that may precede a joint's number in a heading.
inline constexpr std::array kJointWords{"j", "joint", "axis", "a", "q", "theta", "encoder", "jt", "actualq"};

/// Quantity of a measurement table, with its names in other programs.
struct ColumnTarget {
  std::string quantity;          ///< name of the quantity: "x", "theta1", "id"
  std::optional<UnitKind> unit;  ///< kind of unit in the column's name, as in "x_mm"; std::nullopt if it has none
  bool is_number = true;
  bool is_joint = false;
  std::vector<std::string> aliases = {};  ///< alternative names, in the notation of parseHeading()
  const WrittenForm* form = nullptr;      ///< form that has this number ("euler-zyx.z"); null for other quantities
  std::size_t part = 0;                   ///< index of this number within the form
};

/// Returns all quantities that measurements of an arm may state, in the order of a measurement table's columns.
[[nodiscard]] std::vector<ColumnTarget> columnTargets(const deflection::Arm& arm);

/// Columns of one table whose numbers together state an orientation or a position.
struct FormColumns {
  const WrittenForm* form = nullptr;
  std::size_t table = 0;
  std::vector<std::size_t> columns;  ///< column index of each number of the form
  std::vector<const Unit*> units;    ///< unit of each number; null if dimensionless or not stated
  bool is_indicated = false;         ///< true if another column of the table indicates this form
  std::string why = {};              ///< text on excluded forms with the same headings, with the reasons; may be empty
  const char* taken = "";            ///< FormHeadings::taken
};

struct TakenColumn {
  std::string name;        ///< name of the column in a measurement table: "x_mm"
  std::size_t target = 0;  ///< index of the column's quantity in columnTargets()
  std::size_t table = 0;
  std::size_t column = 0;
  double factor = 1;                                  ///< factor for the column's numbers
  std::shared_ptr<const FormColumns> form = nullptr;  ///< form that gives the quantity; null if a column states it
  std::size_t part = 0;                               ///< index of the computed component in columnsOf()
  const Unit* unit = nullptr;                         ///< unit of the column's fields; null if dimensionless
};

/// Units for columns that state none, from --units, keyed by kind.
using UsualUnits = std::map<UnitKind, const Unit*>;

struct ColumnChoice {
  /// Assignments NAME=THEIRS or NAME=FILE:THEIRS, where a factor or divisor may follow: "x_mm=X",
  /// "theta1_deg=log.csv:S*-0.00012".
  std::vector<std::string> columns;
  UsualUnits units;
  std::string orientation = {};  ///< name of the form of orientations; if empty, it is deduced from the headings
  std::string points = {};       ///< name of the form of positions; if empty, it is deduced from the headings
  std::string dates = {};        ///< "day-first" or "month-first", for dates that are valid in both orders
};

/// Returns the column that names the rows of a table: its points, otherwise its ids, according to the headings or the
/// table's shape; std::nullopt if there is none.
[[nodiscard]] std::optional<std::size_t> findNames(const ForeignTable& table, const std::vector<ColumnTarget>& targets);

/// Likely column of a quantity. `unit` is null if the heading states none, or if the column's degrees may be hours.
struct ColumnGuess {
  std::size_t table = 0, column = 0;
  const Unit* unit = nullptr;
};

/// Returns, for each target, the first column that fits and that no earlier target uses; std::nullopt if there is none.
/// Columns for the numbers of a form are returned only if the measurements need the form, according to `kind` or the
/// kinds stated in the rows, and only if no other form fits.
[[nodiscard]] std::vector<std::optional<ColumnGuess>> guessColumns(const std::vector<ForeignTable>& tables,
                                                                   const std::vector<ColumnTarget>& targets,
                                                                   const ColumnChoice& choice = {},
                                                                   const std::string& kind = {});

/// Returns the columns that the user chose and, for other quantities, the columns with matching headings. Tables
/// without headings are interpreted by their number of columns. If the measurements need an orientation or a position
/// that no column states directly, returns the columns of the only form that states it. Throws InputError for a missing
/// chosen column, a quantity with two possible columns, and an orientation with two possible forms. Also throws
/// InputError for a joint without a column, a number without a unit, and a joint in degrees that may be in hours.
[[nodiscard]] std::vector<TakenColumn> takeColumns(const std::vector<ForeignTable>& tables,
                                                   const std::vector<ColumnTarget>& targets, const ColumnChoice& choice,
                                                   const std::string& kind = {});

}  // namespace tubeplan::app
