// The columns of a measurement table: which one holds what, in which unit.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/files/units.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

/// A column of numbers and the unit its name carries.
struct NumberColumn {
  std::size_t index = 0;
  const Unit* unit = nullptr;  ///< null: a plain number
  std::string name;
};

struct MeasurementColumns {
  std::size_t id = 0, kind = 0;
  std::optional<std::size_t> point, setup, split, from;
  std::optional<NumberColumn> load, x, y, z, tool_x, tool_y, tool_z, sigma, sigma_x, sigma_y, sigma_z, turn_sigma,
      temperature, time;
  std::optional<std::size_t> dx, dy, dz;
  std::vector<NumberColumn> joints;              ///< one for each active row
  std::vector<std::size_t> approach_directions;  ///< one for each active row, or none
  std::map<std::string, NumberColumn> own;       ///< by name, of the kinds' own
};

/// In which units a kind's own numbers of that quantity may stand: lengths or angles.
[[nodiscard]] UnitKind unitKindOf(deflection::Quantity quantity);

/// Throws InputError for columns that are unknown, missing, twice there in two units, or without a known unit.
[[nodiscard]] MeasurementColumns findColumns(const tubesheets::CsvTable& table, const std::string& file,
                                             const deflection::Arm& arm);

}  // namespace tubeplan::app
