// Foreign tables in the form that the page shows for choosing columns.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/foreign/foreign_readings.hpp"

namespace tubeplan::app {

/// Returns {tables: [{name, columns, rows: [[field]], count, names}], targets: [{quantity, units, is_required, found:
/// {table, column, unit} or null}], options: [{name, label, values: [{value, words}]}]}: the first rows of each table,
/// every quantity that readings of this arm may state, and its likely column. `unit` is empty if nothing states one;
/// `names` is null if no column has the rows' names. Options are further statements of the user about the tables: kind,
/// orientation, points, dates.
[[nodiscard]] nlohmann::json foreignColumnsJson(const ForeignRequest& request, const Cell& cell);

}  // namespace tubeplan::app
