// Columns of a measurement table, with their indices, units and meanings.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

/// Column of numbers, with the unit in the column's name.
struct NumberColumn {
  std::size_t index = 0;
  const Unit* unit = nullptr;  ///< unit in the column's name; null for a plain number
  std::string name;
};

/// Columns of the three components of a vector; std::nullopt for a missing column.
using ColumnTriple = std::array<std::optional<NumberColumn>, 3>;

struct MeasurementColumns {
  std::size_t id = 0, kind = 0;
  std::optional<std::size_t> point, setup, split, from, row;
  std::optional<NumberColumn> load, sigma, turn_sigma;
  deflection::OfEachCondition<std::optional<NumberColumn>> conditions;
  ColumnTriple place, tool_point, sigmas, correlations, direction, force, moment;
  std::vector<NumberColumn> joints;              ///< columns of joint readings, one for each active row of the arm
  std::vector<NumberColumn> side_joints;         ///< columns of joint readings in side chains, one for each joint
  std::vector<std::size_t> approach_directions;  ///< indices of the columns `<joint>_dir`, one per active row, or empty
  std::map<std::string, NumberColumn>
      kind_columns;  ///< columns of quantities of particular kinds of measurements, keyed by name
};

/// Prefix of a joint's name in run-sheet columns of expected joint readings, for measurements in which the joints are
/// measured.
inline constexpr const char* kNearPrefix = "near_";

/// Advice in messages for a table from another program.
inline constexpr const char* kReadForeign = "let `tubeplan readings` make a measurement table of the file";

/// Returns the kind of units in which a quantity is stated.
[[nodiscard]] UnitKind unitKindOf(deflection::Quantity quantity);

/// Returns the kind of units of a joint's readings: length for a prismatic joint, otherwise angle.
[[nodiscard]] UnitKind unitKindOf(const deflection::Joint<double>& joint);

/// Returns the name of a condition's column with its unit, which is the file's (`temperature_degF`) or fixed
/// (`humidity_percent`).
[[nodiscard]] std::string conditionColumn(const deflection::ConditionKind& kind, const Units& units);

/// Returns the columns of a table. Throws InputError for an unknown or missing column, for a quantity with columns in
/// two units, and for a column with an unknown unit.
[[nodiscard]] MeasurementColumns findColumns(const tubesheets::CsvTable& table, const std::string& file,
                                             const deflection::Arm& arm);

}  // namespace tubeplan::app
