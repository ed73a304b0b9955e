// tubeplan add: the cell with one more effect, to be fitted with the rest.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/atomic_file.hpp"
#include "app/command.hpp"
#include "app/input_error.hpp"
#include "app/readers/cell_writer.hpp"
#include "app/readers/effects_reader.hpp"

namespace tubeplan::app {

namespace {

struct AddOptions {
  std::string cell, effect, out;
};

int run(const AddOptions& options) {
  Cell cell = readCell(options.cell);
  const auto parsed = parseEffect(options.effect, cell.arm, cell.units, "EFFECT@AT");
  const std::string name = deflection::textOf(cell.arm, parsed.effect);
  for (const auto& present : cell.arm.effects)
    if (present.kind == parsed.effect.kind && present.place == parsed.effect.place)
      throw InputError("EFFECT@AT", name + ", which the cell has already", "another effect or place", "");
  checkWritableFile(options.out, "--out");
  cell.arm.effects.push_back(parsed.effect);
  const auto added = freedNames(cell.arm, parsed.effect);
  writeFileAtomically(options.out, cellTextWithEffects(cell, cell.arm, added, options.out), "--out");
  fmt::print("added {} and freed {}\nwrote {}\nnext: tubeplan identify {} MEASUREMENTS --out fitted.yaml\n", name,
             fmt::join(added, ", "), options.out, options.out);
  return kDone;
}

}  // namespace

Run configureAdd(CLI::App& cli) {
  const auto options = std::make_shared<AddOptions>();
  cli.add_option("CELL", options->cell, "the cell file")->required();
  cli.add_option("EFFECT@AT", options->effect,
                 "an effect of the catalogue at a place, backlash@tool.z; with sizes, base-slip@base:time=90")
      ->required();
  cli.add_option("--out", options->out, "write the cell with the effect to this file")->required();
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
