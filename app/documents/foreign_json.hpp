// Tables of other programs as JSON, for the dialog in which the user chooses columns.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/foreign/foreign_measurements.hpp"

namespace tubeplan::app {

/// Returns {tables: [{name, columns, rows: [[field]], count, remarks, names}], targets: [{quantity, units, is_required,
/// found: {table, column, unit} or null}], options: [{name, label, values: [{value, words}]}]}. `rows` are the first
/// rows of each table; `names` is null if no column names the rows. `targets` are all quantities that measurements of
/// this arm may state, each with its probable column; `unit` is empty if the table states no unit. `options` are
/// further choices of the user about the tables: kind, orientation, points, dates.
[[nodiscard]] nlohmann::json foreignColumnsJson(const ForeignRequest& request, const Cell& cell);

}  // namespace tubeplan::app
