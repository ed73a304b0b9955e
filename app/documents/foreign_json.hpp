// Foreign tables as the page shows them for choosing columns.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "app/files/cell_reader.hpp"
#include "app/files/foreign/foreign_columns.hpp"

namespace tubeplan::app {

/// {tables: [{name, columns, rows: [[field]], count, names}], targets: [{quantity, units, is_required, found: {table,
/// column, unit} or null}]}: the first rows of each, every quantity that readings of this arm may state, and which
/// column seems to be it; `unit` is empty where its heading states none, `names` is null where no column has the rows'
/// names.
[[nodiscard]] nlohmann::json foreignColumnsJson(const std::vector<ForeignTable>& tables, const Cell& cell);

}  // namespace tubeplan::app
