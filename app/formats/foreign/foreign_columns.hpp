// Assignment of the columns of foreign tables to those of a measurement table.
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

/// Words that may precede a joint's number.
inline constexpr std::array kJointWords{"j", "joint", "axis", "a", "q", "theta", "encoder", "jt", "actualq"};

/// Quantity of a measurement table, with its names in other programs.
struct ColumnTarget {
  std::string quantity;          ///< name of the quantity: "x", "theta1", "id"
  std::optional<UnitKind> unit;  ///< unit of the column quantity_UNIT, if it has one
  bool is_number = true;
  bool is_joint = false;
  std::vector<std::string> aliases = {};  ///< other names, as parseHeading() returns them
  const WrittenForm* form = nullptr;      ///< form of which it is a number ("euler-zyx.z"); null for a column
  std::size_t part = 0;                   ///< index of the number in the form
};

/// Returns all quantities that readings of an arm may state, in the order of a measurement table.
[[nodiscard]] std::vector<ColumnTarget> columnTargets(const deflection::Arm& arm);

/// Columns of one table whose numbers together state an orientation or a position.
struct FormColumns {
  const WrittenForm* form = nullptr;
  std::size_t table = 0;
  std::vector<std::size_t> columns;  ///< column of each number
  std::vector<const Unit*> units;    ///< unit of each number; null if it has none or none is stated
  bool is_beside = false;            ///< true: another column of the table indicates this form
  std::string why = {};              ///< excluded forms with the same headings, and the reasons; else empty
};

struct TakenColumn {
  std::string name;        ///< name in a measurement table: "x_mm"
  std::size_t target = 0;  ///< index of its quantity in columnTargets()
  std::size_t table = 0;
  std::size_t column = 0;
  double factor = 1;                                  ///< factor of its numbers
  std::shared_ptr<const FormColumns> form = nullptr;  ///< form of which this is a number; else null
  std::size_t part = 0;                               ///< index in the columns of columnsOf()
  const Unit* unit = nullptr;                         ///< unit of its fields; null if they have none
};

/// Units of columns without a stated unit, from --units.
using UsualUnits = std::map<UnitKind, const Unit*>;

struct ColumnChoice {
  /// Assignments NAME=THEIRS or NAME=FILE:THEIRS, with an optional factor or divisor: "x_mm=X",
  /// "theta1_deg=log.csv:S*-0.00012".
  std::vector<std::string> columns;
  UsualUnits units;
  std::string orientation = {};  ///< name of the form of orientations; empty: from their columns
  std::string points = {};       ///< name of the form of positions; empty: from their columns
  std::string dates = {};        ///< "day-first" or "month-first", for dates that are valid in both orders
};

/// Returns the column with the names of a table's rows: its points, else its ids, from its headings or its shape.
[[nodiscard]] std::optional<std::size_t> findNames(const ForeignTable& table, const std::vector<ColumnTarget>& targets);

/// Likely column of a quantity. Its unit is null if the heading states none, or if its degrees may be hours.
struct ColumnGuess {
  std::size_t table = 0, column = 0;
  const Unit* unit = nullptr;
};

/// Returns for each target the first column that fits and is not used by a target before it; nothing if there is none.
/// Numbers of a form are returned only if the readings need it, by `kind` or the kinds in the rows, and it is the only
/// one that fits.
[[nodiscard]] std::vector<std::optional<ColumnGuess>> guessColumns(const std::vector<ForeignTable>& tables,
                                                                   const std::vector<ColumnTarget>& targets,
                                                                   const ColumnChoice& choice = {},
                                                                   const std::string& kind = {});

/// Returns the chosen columns and, for other quantities, the columns with matching headings; tables without headings
/// are interpreted by their number of columns. If the readings need an orientation or a position without columns of its
/// own, returns the columns of the only form that states it. Throws InputError for a missing chosen column, for a
/// quantity with two possible columns or an orientation with two possible forms. It is also thrown for a joint without
/// a column, for a number without a unit and for a joint's degrees that may be hours.
[[nodiscard]] std::vector<TakenColumn> takeColumns(const std::vector<ForeignTable>& tables,
                                                   const std::vector<ColumnTarget>& targets, const ColumnChoice& choice,
                                                   const std::string& kind = {});

}  // namespace tubeplan::app
