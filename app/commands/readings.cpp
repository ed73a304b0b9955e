// `tubeplan readings`: converts tables of other programs into a measurement table.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <memory>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/foreign/clock_time.hpp"
#include "app/formats/foreign/foreign_heading.hpp"
#include "app/formats/foreign/foreign_measurements.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/count_text.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

namespace {

struct MeasurementsOptions {
  std::string cell, out, kind, orientation, points, dates;
  std::vector<std::string> files, columns, units;
  bool is_template = false;
};

std::map<UnitKind, const Unit*> unitsOf(const std::vector<std::string>& words) {
  std::map<UnitKind, const Unit*> units;
  for (const auto& word : words) {
    const Unit* unit = findUnitWord(word);
    if (!unit) throw InputError("--units", inQuotes(word), "a unit such as mm, deg or N");
    if (!units.emplace(unit->kind, unit).second)
      throw InputError::problem(
          "--units", fmt::format("{} and {} are units of the same quantity", units[unit->kind]->name, unit->name),
          "give one unit for each quantity");
  }
  return units;
}

void write(const MeasurementsOptions& options, const std::string& text) {
  if (options.out.empty())
    output("{}", text);
  else
    writeFileAtomically(options.out, text, "--out");
}

/// Returns the number of measurements in the converted text. Throws InputError if that text cannot be read as a
/// measurement table; the error names the line of the source table, because the user has not seen the converted text.
std::size_t countOf(const ForeignMeasurements& measurements, const Cell& cell) {
  const std::string name = "the readings";
  try {
    return parseMeasurementTable(measurements.text, name, cell.arm, cell.sheet ? &*cell.sheet : nullptr)
        .measurements.size();
  } catch (const InputError& error) {
    const std::string line = error.where().substr(std::min(name.size() + 1, error.where().size()));
    const std::size_t row = std::strtoul(line.c_str(), nullptr, 10);
    if (!error.where().starts_with(name + ":") || row < 2 || row - 2 >= measurements.origins.size()) throw;
    throw InputError(measurements.origins[row - 2], error.found(), error.expected(), error.advice());
  }
}

int run(const MeasurementsOptions& options) {
  const Cell cell = readCell(options.cell);
  if (options.is_template) {
    write(options, measurementsCsv({}, cell.arm, cell.units));
    return kDone;
  }
  if (options.files.empty())
    throw InputError::problem("readings", "FILES are missing", "name the tables to read, or give --template");
  ForeignRequest request{
      {}, {options.columns, unitsOf(options.units), options.orientation, options.points, options.dates}, options.kind};
  for (const auto& file : options.files) request.tables.push_back(parseForeignTable(readTextFile(file), file));
  if (!options.out.empty()) checkWritableFile(options.out, "--out");
  const ForeignMeasurements measurements = readForeign(request, cell.arm);
  const std::size_t count = countOf(measurements, cell);
  write(options, measurements.text);
  std::string lines;
  for (const auto& taken : measurements.taken) lines += fmt::format("  {}\n", taken);
  for (const auto& column : measurements.left_out) lines += fmt::format("  left out: {}\n", column);
  remark("{}\n{}", countText(count, "reading"), lines);
  return kDone;
}

}  // namespace

Run configureMeasurements(CLI::App& cli) {
  const auto options = std::make_shared<MeasurementsOptions>();
  addCell(cli, options->cell);
  cli.add_option("FILES", options->files,
                 "tables (CSV, or text with tabs or blanks): joints and positions together, or a joint log and a "
                 "tracker's points");
  cli.add_option(
         "--column", options->columns,
         "NAME=COLUMN: assigns a column whose heading does not say what it is (x_mm=X, theta1=log.csv:J1), with a "
         "factor or divisor for pulses (theta1_deg=S*-0.00012)")
      ->take_all();
  cli.add_option("--units", options->units, "units of columns that state none: mm,deg,N")->delimiter(',');
  cli.add_option("--kind", options->kind,
                 "kind of the readings, if no column states it (default: position, or touch without coordinates)")
      ->check(oneOf(calibration::measurementKindNames()));
  cli.add_option("--orientation", options->orientation, "form of the tool's orientation in the columns")
      ->check(oneOf(formNames(Stated::kTurn)));
  cli.add_option("--points", options->points, "form of the positions in the columns, if it is not x, y, z")
      ->check(oneOf(formNames(Stated::kPlace)));
  cli.add_option("--dates", options->dates, "order of day and month in dates such as 3/5/2024")
      ->check(oneOf({nameOf(DateOrder::kDayFirst), nameOf(DateOrder::kMonthFirst)}));
  cli.add_option("--out", options->out, "write the measurement table to this file (default: standard output)");
  cli.add_flag("--template", options->is_template, "an empty table for this arm, to be filled in");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
