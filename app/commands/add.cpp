// tubeplan add: the cell with one more effect, of the catalogue or the user's own formula, to be fitted with the rest.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/atomic_file.hpp"
#include "app/command.hpp"
#include "app/input_error.hpp"
#include "app/overlap_report.hpp"
#include "app/readers/cell_writer.hpp"
#include "app/readers/effects_reader.hpp"
#include "app/readers/measurements_reader.hpp"
#include "app/reading_input.hpp"
#include "calibration/diagnosis/formula_overlap.hpp"

namespace tubeplan::app {

namespace {

struct AddOptions {
  std::string cell, effect, formula, readings, out;
  double sigma = 0;
};

/// `formula@theta3` or nothing beside a formula, EFFECT@AT without one.
deflection::Effect effectOf(const AddOptions& options, const Cell& cell) {
  const std::string prefix = "formula@";
  const bool is_named = options.effect.starts_with(prefix);
  if (options.formula.empty() && (options.effect.empty() || is_named))
    throw InputError("EFFECT@AT", options.effect.empty() ? "nothing" : inQuotes(options.effect) + " alone",
                     "EFFECT@AT, as backlash@tool.z, or --formula 'theta3 += c*sin(3*theta1)'");
  if (options.formula.empty()) return parseEffect(options.effect, cell.arm, cell.units, "EFFECT@AT").effect;
  if (!options.effect.empty() && !is_named)
    throw InputError("EFFECT@AT", inQuotes(options.effect) + " and a formula", "one of them, or formula@TARGET");
  return parseFormula(options.formula, cell.arm, cell.units, "--formula",
                      is_named ? options.effect.substr(prefix.size()) : "");
}

/// The overlap of what was added with the catalogue, at these readings.
std::string overlapAt(const AddOptions& options, const Cell& cell) {
  auto readings = readMeasurements(options.readings, cell.arm, cell.sheet ? &*cell.sheet : nullptr);
  stateSigma(readings, cell, options.readings, options.sigma);
  requireDefinedFormulas(readings, cell, options.readings);
  calibration::IdentificationOptions asked;
  asked.free = {cell.identify, !cell.base_known};
  asked.folds = 0;
  asked.intervals_by_profile = false;
  const auto result = calibration::identify(cell.arm, cell.X_WB, cell.base_known, readings, asked);
  if (result.status != calibration::IdentificationStatus::kDone)
    return "no overlap with the catalogue can be told: " + result.reason + "\n";
  return overlapText(calibration::findFormulaOverlaps(result, readings));
}

int run(const AddOptions& options) {
  Cell cell = readCell(options.cell);
  const auto effect = effectOf(options, cell);
  const std::string name = deflection::textOf(cell.arm, effect);
  for (const auto& present : cell.arm.effects)
    if (deflection::textOf(cell.arm, present) == name)
      throw InputError("EFFECT@AT", name + ", which the cell has already", "another effect or place", "");
  if (!options.readings.empty() && !effect.formula)
    throw InputError("--readings", "no formula to set beside the catalogue", "--formula with it");
  checkWritableFile(options.out, "--out");
  cell.arm.effects.push_back(effect);
  const auto added = freedNames(cell.arm, effect);
  const std::string text = cellTextWithEffects(cell, cell.arm, added, options.out);
  cell.identify.insert(cell.identify.end(), added.begin(), added.end());
  const std::string overlap = options.readings.empty() ? "" : overlapAt(options, cell);
  writeFileAtomically(options.out, text, "--out");
  fmt::print("added {} and freed {}\n", name, added.empty() ? "nothing" : fmt::format("{}", fmt::join(added, ", ")));
  if (effect.formula) fmt::print("{}\n", formulaUnitsText(cell.arm, effect, cell.units));
  fmt::print("{}wrote {}\nnext: tubeplan identify {} MEASUREMENTS --out fitted.yaml\n", overlap, options.out,
             options.out);
  return kDone;
}

}  // namespace

Run configureAdd(CLI::App& cli) {
  const auto options = std::make_shared<AddOptions>();
  cli.add_option("CELL", options->cell, "the cell file")->required();
  cli.add_option(
      "EFFECT@AT", options->effect,
      "an effect of the catalogue at a place, backlash@tool.z; with sizes, base-slip@base:time=90; not needed "
      "beside --formula");
  cli.add_option(
      "--formula", options->formula,
      "TARGET += EXPRESSION, 'theta3 += c*sin(3*theta1)'. Targets: a joint, tip.x to tip.z, base.x to base.z, "
      "base.yaw. Symbols: the joints (rad; slides as the file's lengths), JOINT_dir (sense of the last "
      "motion), moment_ROW_x to _z, load, temperature, time, in the cell's units. Every other name is a "
      "parameter in the target's unit, zero at first; one that the formula is not proportional to is a plain "
      "number and needs a start: 'theta3 += c*sin(k*theta1); k=3'");
  cli.add_option("--readings", options->readings,
                 "measurements (CSV) at which to say how much of the formula is an effect of the catalogue");
  cli.add_option("--sigma", options->sigma,
                 "noise of a coordinate where --readings states none, in the cell's length unit");
  cli.add_option("--out", options->out, "write the cell with the effect to this file")->required();
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
