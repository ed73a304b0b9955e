// Columns of a measurement table: their indices, units and meanings.
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

/// Column of numbers with the unit in its name.
struct NumberColumn {
  std::size_t index = 0;
  const Unit* unit = nullptr;  ///< unit in the name; null for a plain number
  std::string name;
};

/// Columns of the three components of a vector.
using ColumnTriple = std::array<std::optional<NumberColumn>, 3>;

struct MeasurementColumns {
  std::size_t id = 0, kind = 0;
  std::optional<std::size_t> point, setup, split, from, row;
  std::optional<NumberColumn> load, sigma, turn_sigma;
  deflection::OfEachCondition<std::optional<NumberColumn>> conditions;
  ColumnTriple place, tool_point, sigmas, correlations, direction, force, moment;
  std::vector<NumberColumn> joints;              ///< columns of the joints, one for each active row
  std::vector<NumberColumn> side_joints;         ///< columns of the joints of side chains
  std::vector<std::size_t> approach_directions;  ///< columns `<joint>_dir`, one for each active row, or empty
  std::map<std::string, NumberColumn> own;       ///< columns of the kinds' own quantities, by name
};

/// Prefix of a joint's name in the columns of proposed readings that measure the joint: its expected value.
inline constexpr const char* kNearPrefix = "near_";

/// Advice for a table from another program.
inline constexpr const char* kReadForeign = "let `tubeplan readings` make a measurement table of the file";

/// Returns the kind of units for numbers of a quantity.
[[nodiscard]] UnitKind unitKindOf(deflection::Quantity quantity);

/// Returns the kind of units for a joint's readings.
[[nodiscard]] UnitKind unitKindOf(const deflection::Joint<double>& joint);

/// Returns the name of a condition's column: with the file's unit, `temperature_degF`, or with its own,
/// `humidity_percent`.
[[nodiscard]] std::string conditionColumn(const deflection::ConditionKind& kind, const Units& units);

/// Returns the columns of a table. Throws InputError for columns that are unknown or missing, occur in two units, or
/// have no known unit.
[[nodiscard]] MeasurementColumns findColumns(const tubesheets::CsvTable& table, const std::string& file,
                                             const deflection::Arm& arm);

}  // namespace tubeplan::app
