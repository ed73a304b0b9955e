// `tubeplan add`: adds an effect of the catalogue, or a user formula, to a cell's model, to be fitted together with the
// other parameters.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/commands/option_groups.hpp"
#include "app/formats/cell/cell_places.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/cell/effects_reader.hpp"
#include "app/jobs/effect_addition.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

/// Returns the names of all conditions, each preceded by a comma: ", temperature, time".
std::string conditionNames() {
  std::string names;
  for (const auto& kind : deflection::kConditionKinds) names += std::string(", ") + kind.name;
  return names;
}

struct AddOptions {
  AdditionRequest request;
  std::string cell, measurements, out;
  double sigma = 0;
};

int run(const AddOptions& options) {
  const Cell cell = readCell(options.cell);
  const Addition added = addToCell(cell, options.request);
  if (!options.measurements.empty() && added.formulas.empty())
    throw InputError::problem(
        "--readings", "the readings are needed only to compare a formula with the catalogue, but no formula is given",
        "add --formula, or leave --readings out");
  checkWritableCell(cell, options.out, "--out");
  const std::string text = cellTextWith(cell, added, options.out);
  const std::string overlap = options.measurements.empty()
                                  ? ""
                                  : overlapAt({added.cell, options.measurements,
                                               readMeasurements(options.measurements, added.cell, options.sigma)});
  writeFileAtomically(options.out, text, "--out");
  output("added {} and freed {}\n", fmt::join(added.names, ", "),
         added.freed.empty() ? "nothing" : fmt::format("{}", fmt::join(added.freed, ", ")));
  for (const auto& formula : added.formulas) output("{}\n", formulaUnitsText(added.cell.arm, formula, cell.units));
  output("{}wrote {}\nnext: tubeplan identify {} MEASUREMENTS --out fitted.yaml\n", overlap, options.out, options.out);
  return kDone;
}

}  // namespace

Run configureAdd(CLI::App& cli) {
  const auto options = std::make_shared<AddOptions>();
  addCell(cli, options->cell);
  cli.add_option(
      "EFFECT@AT", options->request.causes,
      "effects of the catalogue, each at its place, backlash@tool.z; with sizes, base-slip@base:time=90; at all "
      "joints, "
      "'joint-compliance@all joints'; or a number of the arm's file to free, free@latch-link.beam.Iz, free@geometry");
  cli.add_option(
      "--formula", options->request.formula,
      "TARGET += EXPRESSION, 'theta3 += c*sin(3*theta1)'. Targets: a joint, tip.x to tip.z, base.x to "
      "base.z, base.yaw. Symbols: the joints (rad; slides in the file's unit of length), JOINT_dir "
      "(direction of the last motion), moment_ROW_x to _z, load" +
          conditionNames() +
          ", in the cell's units. "
          "Every other name is a parameter in the target's unit, initially zero; one in which the formula is "
          "not linear is dimensionless and needs an initial value: 'theta3 += c*sin(k*theta1); k=3'");
  cli.add_option("--readings", options->measurements,
                 "measurements (CSV) for the overlap of the formula with effects of the catalogue");
  addSigma(cli, options->sigma, "if --readings states none");
  cli.add_option("--out", options->out, "write the cell with the effect to this file")->required();
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
