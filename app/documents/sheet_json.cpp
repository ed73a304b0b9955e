#include "app/documents/sheet_json.hpp"

#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/formats/units.hpp"

namespace tubeplan::app {

nlohmann::json manwayJson(const tubesheets::Sheet& sheet, const Units& units) {
  if (!sheet.manway) return nullptr;
  return {{"center", placeJson(sheet.manway->centre, units)}, {"diameter", lengthJson(sheet.manway->diameter, units)}};
}

nlohmann::json sheetPageJson(const tubesheets::Sheet& sheet, const Cell& cell) {
  const Units& units = cell.units;
  nlohmann::json holes = nlohmann::json::array(), state_words, manway;
  if (sheet.manway) manway = {sheet.manway->direction().x(), sheet.manway->direction().y()};
  for (const auto& tube : sheet.tubes)
    holes.push_back({tube.row, tube.column, lengthOf(tube.x, units), lengthOf(tube.y, units),
                     tubesheets::tubeStateName(tube.state)});
  for (const auto state : tubesheets::tubeStates())
    state_words[std::string(tubesheets::tubeStateName(state))] = tubesheets::tubeStateWords(state);
  return {{"name", cell.name},
          {"leg", tubesheets::legName(sheet.leg)},
          {"leg_words", tubesheets::legWords(sheet.leg)},
          {"viewed_from", tubesheets::viewedFromName(sheet.viewed_from)},
          {"view_words", tubesheets::viewedFromWords(sheet.viewed_from)},
          {"hole_diameter", lengthOf(sheet.hole_diameter, units)},
          {"pitch", lengthOf(sheet.pitch, units)},
          {"rows", sheet.rows},
          {"columns", sheet.columns},
          {"holes", holes},
          {"state_words", state_words},
          {"manway", manway},
          {"fingerprint", sheet.fingerprint()}};
}

}  // namespace tubeplan::app
