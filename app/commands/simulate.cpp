// tubeplan simulate: measurements of a cell to practise on, and the truth in a file of its own.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/atomic_file.hpp"
#include "app/campaign_clearance.hpp"
#include "app/command.hpp"
#include "app/command_inputs.hpp"
#include "app/input_error.hpp"
#include "app/progress.hpp"
#include "app/readers/campaign_reader.hpp"
#include "app/readers/effects_reader.hpp"
#include "app/readers/measurements_writer.hpp"
#include "app/stop_signal.hpp"
#include "app/suggestion.hpp"
#include "app/truth_file.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

namespace {

using calibration::CampaignDesign, calibration::CampaignPlace, calibration::CampaignStatus;
using calibration::kMostReadings, calibration::MeasurementKind;

/// In the cell's units, as typed.
struct SimulateOptions {
  std::string cell, design, out;
  std::optional<int> readings;
  std::vector<double> loads, base_error;
  std::vector<std::string> hide;
  std::optional<double> sigma, held_out;
  double spread = 0;
  std::uint64_t seed = 1;
};

/// The error of a base that is not known, where no other is asked for.
constexpr double kBaseShift = 0.0127;                     // m (0.5 in)
constexpr double kBaseTurn = 0.5 * 0.017453292519943295;  // rad

CampaignFile findDesign(const SimulateOptions& options, const Cell& cell) {
  const bool has_sheet = cell.sheet.has_value();
  if (const auto* named = calibration::findCampaignDesign(options.design))
    return {named->make(has_sheet), std::nullopt};
  std::error_code error;
  const auto extension = std::filesystem::path(options.design).extension();
  if (extension == ".yaml" || extension == ".yml" || std::filesystem::exists(options.design, error))
    return readCampaignFile(options.design, cell.units, has_sheet);
  std::vector<std::string> names;
  for (const auto& named : calibration::campaignDesigns()) names.emplace_back(named.name);
  const std::string near = suggestion(options.design, names);
  names.emplace_back("a design file (.yaml)");
  throw InputError("--design", "the unknown design " + inQuotes(options.design), alternatives(names), near);
}

void checkNotNegative(const std::string& option, double value, const std::string& expected) {
  if (!(value >= 0) || !std::isfinite(value)) throw InputError(option, fmt::format("{}", value), expected);
}

void applyOptions(const SimulateOptions& options, const Units& units, CampaignDesign& design) {
  if (!options.loads.empty()) design.loads.clear();
  for (const double load : options.loads) {
    checkNotNegative("--loads", load, fmt::format("weights in {}, zero or more", units.force().name));
    design.loads.push_back(units.toInternal(load, dimension::kForce));
  }
  if (options.sigma) {
    checkNotNegative("--sigma", *options.sigma, fmt::format("a length in {}, zero or more", units.length().name));
    design.sigma = units.toInternal(*options.sigma, dimension::kLength);
  }
  if (!options.held_out) return;
  if (!(*options.held_out >= 0 && *options.held_out < 1))
    throw InputError("--held-out", fmt::format("{}", *options.held_out), "a share from 0 to below 1");
  design.held_out = *options.held_out;
}

int countReadings(const SimulateOptions& options, const CampaignFile& file) {
  const std::string expected = fmt::format("a whole number from 1 to {}", kMostReadings);
  if (!options.readings && !file.postures)
    throw InputError("--readings", "nothing", expected, "add --readings N, or `postures` to the design file");
  const auto readings =
      options.readings ? *options.readings : *file.postures * static_cast<std::int64_t>(file.design.loads.size());
  if (readings < 1 || readings > kMostReadings)
    throw InputError(options.readings ? "--readings" : options.design, fmt::format("{} readings", readings), expected);
  return static_cast<int>(readings);
}

void requireHoles(const Cell& cell, const CampaignDesign& design) {
  if (design.place != CampaignPlace::kHoles) return;
  (void)requireSheet(cell, "measure at its holes");
  if (!cell.tool_axis_told)
    throw InputError(
        cell.path, "no word on which way the tool enters a hole", "it: needed to measure at holes",
        "add tool: {axis: [x, y, z]} to the arm file, or a scene whose sheet allows a capsule of the tool");
}

std::vector<calibration::CampaignPoint> openHoles(const Cell& cell) {
  std::vector<calibration::CampaignPoint> holes;
  if (!cell.sheet) return holes;
  for (const auto& tube : cell.sheet->tubes)
    if (tube.state == tubesheets::TubeState::kOpen)
      holes.push_back({tubesheets::tubeName(tube.row, tube.column), planner::holeCentre(tube)});
  return holes;
}

/// How far the base may be from where the cell has it.
struct BaseError {
  double shift = 0, turn = 0;  // m, rad
};

BaseError baseErrorOf(const SimulateOptions& options, const Cell& cell, const CampaignDesign& design) {
  if (cell.base_known && !options.base_error.empty())
    throw InputError("--base-error", "a base that is known", "base: {..., known: false} in " + cell.path);
  if (cell.base_known && design.setups > 1)
    throw InputError(cell.path, fmt::format("one known base for {} set-ups", design.setups),
                     "base: {..., known: false}, since each set-up has a base of its own");
  if (cell.base_known) return {};
  if (options.base_error.empty()) return {kBaseShift, kBaseTurn};
  if (options.base_error.size() != 2)
    throw InputError("--base-error", fmt::format("{} numbers", options.base_error.size()), "two: LENGTH,ANGLE");
  for (const double error : options.base_error) checkNotNegative("--base-error", error, "LENGTH,ANGLE, zero or more");
  return {cell.units.toInternal(options.base_error[0], dimension::kLength),
          cell.units.toInternal(options.base_error[1], dimension::kAngle)};
}

/// An effect as large as machines often have it: a fifth of what is plausible.
deflection::Effect ofTypicalSize(deflection::Effect effect) {
  const auto& kind = deflection::effectKinds().at(static_cast<std::size_t>(effect.kind));
  for (std::size_t v = 0; v < effect.values.size(); ++v)
    if (!kind.parameters[v].is_shape)
      effect.values[v] = kind.parameters[v].neutral + 0.2 * kind.parameters[v].plausible;
  return effect;
}

/// The arm and the bases that the readings are made with: whatever is hidden from the cell is put in here.
calibration::CampaignTruth makeTruth(const SimulateOptions& options, const Cell& cell, const CampaignDesign& design,
                                     const BaseError& base) {
  checkNotNegative("--spread", options.spread, "a share of each stiffness, zero or more");
  if (options.spread > 1) throw InputError("--spread", fmt::format("{}", options.spread), "a share up to 1");
  calibration::TruthOptions truth;
  truth.parameters = identifiedParameters(cell);
  if (options.spread > 0 && truth.parameters.empty())
    throw InputError(cell.path, "no parameters under `identify`", "them: needed for --spread");
  truth.spread = options.spread;
  truth.base_shift_sigma = base.shift;
  truth.base_turn_sigma = base.turn;
  truth.setups = design.setups;
  truth.seed = options.seed;
  calibration::CampaignTruth drawn = calibration::drawTruth(cell.arm, cell.X_WB, truth);
  for (const std::string& text : options.hide) {
    const auto parsed = parseEffect(text, cell.arm, cell.units, "--hide");
    drawn.arm.effects.push_back(parsed.has_sizes ? parsed.effect : ofTypicalSize(parsed.effect));
  }
  return drawn;
}

calibration::SimulatedCampaign measure(const Cell& cell, const calibration::CampaignTruth& truth,
                                       const CampaignDesign& design, int readings, std::uint64_t seed) {
  calibration::CampaignOptions campaign;
  campaign.readings = readings;
  campaign.seed = seed;
  campaign.holes = openHoles(cell);
  campaign.hole_axis_W = planner::kHoleAxis_W;
  const bool touches_holes = design.kind == MeasurementKind::kTouch && design.place == CampaignPlace::kHoles;
  campaign.is_clear = clearanceOf(cell, truth, touches_holes);
  noteStopSignals();
  Progress progress("readings", static_cast<std::size_t>(readings));
  return calibration::simulateCampaign(truth, design, campaign,
                                       {[&](std::size_t done, std::size_t) { progress.update(done); }, stopRequested});
}

int run(const SimulateOptions& options) {
  const Cell cell = readCell(options.cell);
  CampaignFile file = findDesign(options, cell);
  CampaignDesign& design = file.design;
  applyOptions(options, cell.units, design);
  const int readings = countReadings(options, file);
  if (const auto problem = calibration::findDesignProblem(design, readings); !problem.empty())
    throw InputError("--design " + options.design, problem, "a campaign that can be measured",
                     "see `tubeplan simulate --help`");
  requireHoles(cell, design);
  const BaseError base = baseErrorOf(options, cell, design);
  const auto truth = makeTruth(options, cell, design, base);
  OutputFolder folder(options.out, "--out");
  const auto campaign = measure(cell, truth, design, readings, options.seed);
  if (campaign.status != CampaignStatus::kDone) {
    fmt::print(stderr, "no campaign: {}\n", campaign.reason);
    return campaign.status == CampaignStatus::kStopped ? kStoppedExitCode : kNegativeAnswer;
  }
  folder.write("measurements.csv", measurementsCsv(campaign.readings, cell.arm, cell.units));
  folder.write("truth.yaml",
               truthYaml({cell, design, truth, campaign, options.seed, options.spread, base.shift, base.turn}));
  folder.commit();
  fmt::print(
      "{}: {} readings of kind {}, {} held out\nwrote {}\n", design.name, campaign.readings.size(),
      measurementKindName(design.kind),
      std::count_if(campaign.readings.begin(), campaign.readings.end(), [](const auto& m) { return m.is_held_out; }),
      (folder.path() / "{measurements.csv,truth.yaml}").string());
  return kDone;
}

std::string designHelp() {
  std::string text =
      "one of these, or a YAML file {kind, at, points, postures, postures_per_point, loads, anchor, "
      "region, setups, split, sigma}:";
  for (const auto& named : calibration::campaignDesigns()) text += fmt::format("\n{}: {}", named.name, named.summary);
  return text;
}

}  // namespace

Run configureSimulate(CLI::App& cli) {
  const auto options = std::make_shared<SimulateOptions>();
  cli.add_option("CELL", options->cell, "the cell file")->required();
  cli.add_option("--design", options->design, designHelp())->required();
  cli.add_option("--readings", options->readings, "how many; a design file may say `postures` instead");
  cli.add_option("--seed", options->seed, "of everything random")->check(CLI::NonNegativeNumber)->capture_default_str();
  cli.add_option("--out", options->out, "the folder for measurements.csv and truth.yaml")->required();
  cli.add_option("--loads", options->loads, "hung on the tip in turn, in the cell's unit of force: 0,20,40")
      ->delimiter(',')
      ->allow_extra_args(false);
  cli.add_option("--sigma", options->sigma, "noise of a coordinate, in the cell's unit of length");
  cli.add_option("--spread", options->spread, "how far the true stiffnesses under `identify` are off: 0.1 is 10 %");
  cli.add_option("--base-error", options->base_error, "LENGTH,ANGLE: how far a base that is not known is off")
      ->delimiter(',')
      ->allow_extra_args(false);
  cli.add_option("--hide", options->hide,
                 "EFFECT@AT[:SIZE]: an effect that the cell does not have, backlash@tool.z:0.15deg or "
                 "stiffening@tool.z:softness=0.6,knee=200, or a formula with its sizes, 'theta3 += c*sin(3*theta1); "
                 "c=0.1'; may be "
                 "repeated")
      ->allow_extra_args(false);
  cli.add_option("--held-out", options->held_out, "share of the points or postures kept from the fit: 0.3");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
