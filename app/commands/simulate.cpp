// `tubeplan simulate`: simulates measurements of a cell for practice, and writes the true values to a separate file.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/commands/option_groups.hpp"
#include "app/formats/cell/simulation_input.hpp"
#include "app/formats/cell/truth_file.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/count_text.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

namespace {

using calibration::CampaignStatus;

struct SimulateOptions {
  std::string cell, out;
  SimulationRequest request;
};

calibration::SimulatedCampaign measure(const Cell& cell, const SimulationTask& task, std::uint64_t seed) {
  Progress progress("readings", static_cast<std::size_t>(task.measurements));
  return simulateMeasurements(cell, task, seed,
                              {[&](std::size_t done, std::size_t) { progress.update(done); }, stopCondition()});
}

int run(const SimulateOptions& options) {
  const auto& request = options.request;
  const Cell cell = readCell(options.cell);
  const SimulationTask task = prepareSimulation(cell, request);
  noteStopSignals();  // installed before the first folder is created, so that a stop removes the folder
  OutputFolder folder(options.out, "--out");
  folder.requireOwn({"truth.yaml"}, {"measurements.csv"});
  const auto campaign = measure(cell, task, request.seed);
  if (campaign.status != CampaignStatus::kDone) {
    remark("no campaign: {}\n", campaign.reason);
    return campaign.status == CampaignStatus::kStopped ? kStoppedExitCode : kNegativeAnswer;
  }
  folder.write("measurements.csv", measurementsCsv(campaign.measurements, cell.arm, cell.units));
  folder.write("truth.yaml", truthYaml({cell, task.design, task.truth, campaign, request.seed, request.spread,
                                        task.base.shift, task.base.turn}));
  folder.commit();
  output("{}: {} of kind {}, {} held out\nwrote {}\n", task.design.name,
         countText(campaign.measurements.size(), "reading"), calibration::kindOf(task.design.kind).name,
         std::count_if(campaign.measurements.begin(), campaign.measurements.end(),
                       [](const auto& m) { return m.is_held_out; }),
         (folder.path() / "{measurements.csv,truth.yaml}").string());
  return kDone;
}

std::string designHelp() {
  std::string text =
      "one of these, or a YAML file {kind, at, points, postures, postures_per_point, loads, push, rows, anchor, "
      "direction, region, setups, split, sigma, sigmas, correlations, turn_sigma}:";
  for (const auto& named : calibration::campaignDesigns()) text += fmt::format("\n{}: {}", named.name, named.summary);
  return text;
}

}  // namespace

Run configureSimulate(CLI::App& cli) {
  const auto options = std::make_shared<SimulateOptions>();
  addCell(cli, options->cell);
  cli.add_option("--design", options->request.design, designHelp())->required();
  cli.add_option("--readings", options->request.measurements,
                 "number of readings; a design file may state `postures` instead");
  addSeed(cli, options->request.seed, "seed of the random numbers");
  cli.add_option("--out", options->out, "the folder for measurements.csv and truth.yaml")
      ->type_name("FOLDER")
      ->required();
  cli.add_option("--loads", options->request.loads,
                 "loads hung on the tip, in the cell's unit of force: 0,20,40 (0, 20 and 40 lbf where left out)")
      ->type_name("FORCE")
      ->delimiter(',')
      ->allow_extra_args(false);
  cli.add_option("--push", options->request.push,
                 "a force of random direction on the tip, up to this size, in addition to the load, in the cell's unit "
                 "of force")
      ->type_name("FORCE");
  cli.add_option("--sigma", options->request.sigma, "standard deviation of a coordinate, in the cell's unit of length")
      ->type_name("LENGTH");
  cli.add_option("--spread", options->request.spread,
                 "relative error of the true stiffnesses under `identify`: 0.1 is 10 %");
  cli.add_option("--base-error", options->request.base_error, "LENGTH,ANGLE: error of a base pose that is not known")
      ->type_name("LENGTH,ANGLE")
      ->delimiter(',')
      ->allow_extra_args(false);
  cli.add_option("--hide", options->request.hide,
                 "EFFECT@AT[:SIZE]: an effect that the cell does not have, backlash@tool.z:0.15deg or "
                 "stiffening@tool.z:softness=0.6,knee=200, or a formula with its sizes, 'theta3 += c*sin(3*theta1); "
                 "c=0.1'; may be "
                 "repeated")
      ->allow_extra_args(false);
  cli.add_option("--held-out", options->request.held_out, "fraction of the points or postures held out: 0.3");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
