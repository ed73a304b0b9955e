// Which column of foreign tables is which of a measurement table's.
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

/// Before a joint's number.
inline constexpr std::array kJointWords{"j", "joint", "axis", "a", "q", "theta", "encoder", "jt", "actualq"};

/// A quantity that a measurement table may have, and what it is called elsewhere.
struct ColumnTarget {
  std::string quantity;          ///< "x", "theta1", "id"
  std::optional<UnitKind> unit;  ///< of those with one: the column is quantity_UNIT
  bool is_number = true;
  bool is_joint = false;
  std::vector<std::string> aliases = {};  ///< as parseHeading() gives names
  const WrittenForm* form = nullptr;      ///< it is no column, but a number of that form: "euler-zyx.z"
  std::size_t part = 0;                   ///< and which
};

/// All that readings of that arm may state, in the order of a measurement table.
[[nodiscard]] std::vector<ColumnTarget> columnTargets(const deflection::Arm& arm);

/// Columns of one table whose numbers state a turn or a place together.
struct FormColumns {
  const WrittenForm* form = nullptr;
  std::size_t table = 0;
  std::vector<std::size_t> columns;  ///< of each number
  std::vector<const Unit*> units;    ///< of each; null where it has none or none is stated
  bool is_beside = false;            ///< a column beside them decides for the form
  std::string why = {};              ///< where others with the same headings were excluded: which, and by what
};

struct TakenColumn {
  std::string name;        ///< in a measurement table: "x_mm"
  std::size_t target = 0;  ///< index in columnTargets()
  std::size_t table = 0;
  std::size_t column = 0;
  double factor = 1;                                  ///< what its numbers are multiplied by
  std::shared_ptr<const FormColumns> form = nullptr;  ///< of which it is ...
  std::size_t part = 0;                               ///< ... the number of its columnsOf()
  const Unit* unit = nullptr;                         ///< that its fields are in; null where they have none
};

/// Units of columns that state none, as --units.
using UsualUnits = std::map<UnitKind, const Unit*>;

struct ColumnChoice {
  /// NAME=THEIRS or NAME=FILE:THEIRS, with a factor or a divisor behind: "x_mm=X", "theta1_deg=log.csv:S*-0.00012".
  std::vector<std::string> columns;
  UsualUnits units;
  std::string orientation = {};  ///< the form that turns are written in; empty: the one that their columns say
  std::string points = {};       ///< the same of places
  std::string dates = {};        ///< "day-first" or "month-first", where the rows leave it open
};

/// The column with the names of a table's rows: its points, else its ids, by its headings or, without these, its shape.
[[nodiscard]] std::optional<std::size_t> findNames(const ForeignTable& table, const std::vector<ColumnTarget>& targets);

/// What a column seems to be by its heading; its unit is null where the heading states none, and where its degrees may
/// be hours.
struct ColumnGuess {
  std::size_t table = 0, column = 0;
  const Unit* unit = nullptr;
};

/// Numbers of a form are looked for where the readings need them: by `kind`, else by the kinds that the rows state.
/// For each target the first column that no target before it has; nothing where there is none. Numbers of a form only
/// where the readings need it and it is the only one.
[[nodiscard]] std::vector<std::optional<ColumnGuess>> guessColumns(const std::vector<ForeignTable>& tables,
                                                                   const std::vector<ColumnTarget>& targets,
                                                                   const ColumnChoice& choice = {},
                                                                   const std::string& kind = {});

/// Those chosen, and of the rest those whose headings say what they are; tables without headings by how many columns
/// they have. Where the readings need a turn or a place that no column is, those of the one form that states it. Throws
/// InputError for a choice of a column that is not there, for a quantity that two columns could be or a turn that two
/// forms could mean, for a joint without a column, for a number without a unit and for a joint's degrees that may be
/// hours.
[[nodiscard]] std::vector<TakenColumn> takeColumns(const std::vector<ForeignTable>& tables,
                                                   const std::vector<ColumnTarget>& targets, const ColumnChoice& choice,
                                                   const std::string& kind = {});

}  // namespace tubeplan::app
