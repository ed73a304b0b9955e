// The columns of a measurement table: which one holds what, in which unit.
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

/// A column of numbers and the unit its name carries.
struct NumberColumn {
  std::size_t index = 0;
  const Unit* unit = nullptr;  ///< null: a plain number
  std::string name;
};

/// The columns of three numbers that belong together.
using ColumnTriple = std::array<std::optional<NumberColumn>, 3>;

struct MeasurementColumns {
  std::size_t id = 0, kind = 0;
  std::optional<std::size_t> point, setup, split, from, row;
  std::optional<NumberColumn> load, sigma, turn_sigma;
  deflection::OfEachCondition<std::optional<NumberColumn>> conditions;
  ColumnTriple place, tool_point, sigmas, correlations, direction, force, moment;
  std::vector<NumberColumn> joints;              ///< one for each active row
  std::vector<NumberColumn> side_joints;         ///< one for each joint of a side chain
  std::vector<std::size_t> approach_directions;  ///< one for each active row, or none
  std::map<std::string, NumberColumn> own;       ///< by name, of the kinds' own
};

/// Before the name of a joint: where it will stand, of a reading that is proposed and measures it.
inline constexpr const char* kNearPrefix = "near_";

/// What to do with a table that another program wrote.
inline constexpr const char* kReadForeign = "let `tubeplan readings` make a measurement table of the file";

/// In which units numbers of that quantity may stand.
[[nodiscard]] UnitKind unitKindOf(deflection::Quantity quantity);

/// Of a joint's reading.
[[nodiscard]] UnitKind unitKindOf(const deflection::Joint<double>& joint);

/// The column of a condition: in the file's unit, `temperature_degF`, or in its own, `humidity_percent`.
[[nodiscard]] std::string conditionColumn(const deflection::ConditionKind& kind, const Units& units);

/// Throws InputError for columns that are unknown, missing, twice there in two units, or without a known unit.
[[nodiscard]] MeasurementColumns findColumns(const tubesheets::CsvTable& table, const std::string& file,
                                             const deflection::Arm& arm);

}  // namespace tubeplan::app
