// tubeplan ladder: the error of each model in turn, fitted and held-out, against the noise floor.
#include "app/ladder.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/atomic_file.hpp"
#include "app/command.hpp"
#include "app/command_inputs.hpp"
#include "app/input_error.hpp"
#include "app/readers/measurements_reader.hpp"
#include "app/reading_input.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

struct LadderOptions {
  std::string measurements, json, report;
  std::vector<std::string> cells;
  double sigma = 0;
  std::uint64_t seed = 1;
};

/// What the page wants of the figures.
nlohmann::json ladderPage(const nlohmann::json& figures, const LadderOptions& options) {
  nlohmann::json page = {{"title", "Ladder of models"}, {"measurements", options.measurements},
                         {"seed", options.seed},        {"version", kVersion},
                         {"units", figures["units"]},   {"models", nlohmann::json::array()}};
  for (const auto& rung : figures["rungs"]) {
    page["noise_floor"] = rung["rms"]["noise_floor"];
    page["models"].push_back({{"name", rung["name"]},
                              {"rms", rung["rms"]["fitted"]},
                              {"heldout_rms", rung["rms"]["heldout"]},
                              {"chi2_per_dof", rung["chi2_per_dof"]},
                              {"numbers", rung["fitted_numbers"]}});
  }
  return page;
}

int run(const LadderOptions& options) {
  std::vector<Rung> rungs;
  checkJsonTarget(options.json);
  if (!options.report.empty()) checkWritableFile(options.report, "--report");
  std::optional<Units> units;
  for (const auto& path : options.cells) {
    const Cell cell = readCell(path);
    auto readings = readMeasurements(options.measurements, cell.arm, cell.sheet ? &*cell.sheet : nullptr);
    stateSigma(readings, cell, options.measurements, options.sigma);
    requireDefinedFormulas(readings, cell, options.measurements);
    rungs.push_back(rungOf(path, cell, readings, options.seed));
    if (!units) units = cell.units;
  }
  const auto json = ladderJson(rungs, *units);
  writeJson(options.json, json);
  if (!options.report.empty())
    writeFileAtomically(options.report, renderLadderReport(ladderPage(json, options)), "--report");
  if (printsText(options.json)) fmt::print("{}", ladderText(rungs, *units));
  return kDone;
}

}  // namespace

Run configureLadder(CLI::App& cli) {
  const auto options = std::make_shared<LadderOptions>();
  cli.add_option("MEASUREMENTS", options->measurements, "readings of any kind (CSV)")->required();
  cli.add_option("CELL", options->cells, "models, one cell file each, in the order of the ladder")->required();
  cli.add_option("--sigma", options->sigma, "noise of a coordinate where the file states none");
  cli.add_option("--report", options->report, "write the ladder as a page to this file (HTML)");
  cli.add_option("--seed", options->seed, "seed of the folds");
  cli.add_option("--json", options->json, "write the figures as JSON to this file, or - for standard output");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
