// Foreign tables as the page shows them for choosing columns.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/foreign/foreign_readings.hpp"

namespace tubeplan::app {

/// {tables: [{name, columns, rows: [[field]], count, names}], targets: [{quantity, units, is_required, found: {table,
/// column, unit} or null}], options: [{name, label, values: [{value, words}]}]}: the first rows of each, every quantity
/// that readings of this arm may state, and which column seems to be it; `unit` is empty where nothing states one,
/// `names` is null where no column has the rows' names. Options are what else the user may say of the tables: kind,
/// orientation, points, dates.
[[nodiscard]] nlohmann::json foreignColumnsJson(const ForeignRequest& request, const Cell& cell);

}  // namespace tubeplan::app
