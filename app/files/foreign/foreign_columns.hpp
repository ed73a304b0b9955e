// Which column of foreign tables is which of a measurement table's.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/files/foreign/foreign_table.hpp"
#include "app/files/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Before a joint's number.
inline constexpr std::array kJointWords{"j", "joint", "axis", "a", "q", "theta", "encoder"};

/// A quantity that a measurement table may have, and what it is called elsewhere.
struct ColumnTarget {
  std::string quantity;          ///< "x", "theta1", "id"
  std::optional<UnitKind> unit;  ///< of those with one: the column is quantity_UNIT
  bool is_number = true;
  bool is_joint = false;
  std::vector<std::string> aliases;  ///< as parseHeading() gives names
};

/// All that readings of that arm may state, in the order of a measurement table.
[[nodiscard]] std::vector<ColumnTarget> columnTargets(const deflection::Arm& arm);

struct TakenColumn {
  std::string name;        ///< in a measurement table: "x_mm"
  std::size_t target = 0;  ///< index in columnTargets()
  std::size_t table = 0;
  std::size_t column = 0;
};

struct ColumnChoice {
  std::vector<std::string> columns;       ///< NAME=THEIRS or NAME=FILE:THEIRS: "x_mm=X", "theta1_deg=log.csv:J1"
  std::map<UnitKind, const Unit*> units;  ///< of columns whose headings state none
};

/// The column with the names of a table's rows: its points, else its ids, by its headings or, without these, its shape.
[[nodiscard]] std::optional<std::size_t> findNames(const ForeignTable& table, const std::vector<ColumnTarget>& targets);

/// What a column seems to be by its heading; its unit is null where the heading states none.
struct ColumnGuess {
  std::size_t table = 0, column = 0;
  const Unit* unit = nullptr;
};

/// For each target the first column that no target before it has; nothing where there is none.
[[nodiscard]] std::vector<std::optional<ColumnGuess>> guessColumns(const std::vector<ForeignTable>& tables,
                                                                   const std::vector<ColumnTarget>& targets);

/// Those chosen, and of the rest those whose headings say what they are; tables without headings by how many columns
/// they have. Throws InputError for a choice of a column that is not there, for a quantity that two columns could be,
/// for a joint without a column and for a number without a unit.
[[nodiscard]] std::vector<TakenColumn> takeColumns(const std::vector<ForeignTable>& tables,
                                                   const std::vector<ColumnTarget>& targets,
                                                   const ColumnChoice& choice);

}  // namespace tubeplan::app
