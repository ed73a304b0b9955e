#include "app/sheet_json.hpp"

#include <nlohmann/json.hpp>

#include "app/workcell.hpp"

namespace tubeplan::app {

nlohmann::json sheetPageJson(const tubesheets::Sheet& sheet, const Cell& cell) {
  const Units& units = cell.units;
  auto holes = nlohmann::json::array();
  for (const auto& tube : sheet.tubes)
    holes.push_back({tube.row, tube.column, lengthOf(tube.x, units), lengthOf(tube.y, units),
                     tubesheets::tubeStateName(tube.state)});
  return {{"name", cell.name},
          {"leg", tubesheets::legName(sheet.leg)},
          {"viewed_from", tubesheets::viewedFromName(sheet.viewed_from)},
          {"hole_diameter", lengthOf(sheet.hole_diameter, units)},
          {"pitch", lengthOf(sheet.pitch, units)},
          {"rows", sheet.rows},
          {"columns", sheet.columns},
          {"holes", holes},
          {"fingerprint", sheet.fingerprint()}};
}

}  // namespace tubeplan::app
