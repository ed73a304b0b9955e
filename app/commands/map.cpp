// `tubeplan map`: shows or exports the holes of a cell's tube sheet.
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/sheet_json.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"
#include "tubesheets/hole_map_csv.hpp"

namespace tubeplan::app {

namespace {

struct MapOptions {
  std::string cell, csv;
  FiguresTarget figures;
};

Eigen::AlignedBox2d extentsOf(const tubesheets::Sheet& sheet) {
  Eigen::AlignedBox2d box;
  for (const auto& tube : sheet.tubes) box.extend(Eigen::Vector2d(tube.x, tube.y));
  return box;
}

std::map<std::string, int> countStates(const tubesheets::Sheet& sheet) {
  std::map<std::string, int> counts;
  for (const auto& tube : sheet.tubes) ++counts[std::string(tubesheets::tubeStateName(tube.state))];
  return counts;
}

nlohmann::json mapJson(const Cell& cell, const tubesheets::Sheet& sheet) {
  const auto box = extentsOf(sheet);
  const auto length = [&](double metres) { return cell.units.toFile(metres, dimension::kLength); };
  return {
      {"name", cell.name},
      {"holes", sheet.tubes.size()},
      {"rows", sheet.rows},
      {"columns", sheet.columns},
      {"layout", sheet.layout_type},
      {"pitch", length(sheet.pitch)},
      {"hole_diameter", length(sheet.hole_diameter)},
      {"leg", tubesheets::legName(sheet.leg)},
      {"viewed_from", tubesheets::viewedFromName(sheet.viewed_from)},
      {"extents",
       {{"x", {length(box.min().x()), length(box.max().x())}}, {"y", {length(box.min().y()), length(box.max().y())}}}},
      {"states", countStates(sheet)},
      {"manway", manwayJson(sheet, cell.units)},
      {"fingerprint", sheet.fingerprint()},
      {"warnings", cell.warnings},
      {"units", unitsJson(cell.units)}};
}

constexpr TextLine kMapWords[] = {
    {"",
     "{name}: {holes} hole(|s), rows up to {rows}, columns up to {columns}\n"
     "layout {layout}, pitch {pitch: units/length}, hole diameter {hole_diameter: units/length}\n"
     "{leg} leg, viewed from {viewed_from}\n"
     "x {extents/x/0} to {extents/x/1: units/length}, y {extents/y/0} to {extents/y/1: units/length}\n{states}\n"},
    {"manway", "manway of diameter {diameter: units/length} at {center: units/length}\n"},
    {"", "fingerprint {fingerprint}\n"},
    {"warnings", "warning: {}\n"}};

// Returns the length unit of the exported map: the cell's unit if it is in, mm or m, otherwise inches.
const tubesheets::LengthUnit& csvUnit(const Cell& cell) {
  const auto* unit = tubesheets::findLengthUnit(cell.units.length().name);
  return unit ? *unit : tubesheets::kInch;
}

int run(const MapOptions& options) {
  const Cell cell = readCell(options.cell);
  const tubesheets::Sheet& sheet = requireSheet(cell, "list its holes");
  checkFigures(options.figures);
  if (!options.csv.empty()) writeFileAtomically(options.csv, tubesheets::formatHoleMap(sheet, csvUnit(cell)), "--csv");
  const nlohmann::json figures = mapJson(cell, sheet);
  showFigures(options.figures, figures, textOf(figures, kMapWords));
  return kDone;
}

}  // namespace

Run configureMap(CLI::App& cli) {
  const auto options = std::make_shared<MapOptions>();
  addCell(cli, options->cell);
  cli.add_option("--csv", options->csv, "write the hole map to this file: row,column,x,y,state");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
