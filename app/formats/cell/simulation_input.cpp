#include "app/formats/cell/simulation_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/formats/cell/campaign_reader.hpp"
#include "app/formats/cell/effects_reader.hpp"
#include "app/formats/cell/truth_file.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "app/studies/measurements/campaign_clearance.hpp"
#include "calibration/measurements/counted_section.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

namespace {

using calibration::CampaignDesign, calibration::CampaignPlace;
using calibration::kMostMeasurements;

/// Default standard deviations of an unknown base pose.
constexpr double kBaseShift = 0.0127;                     // standard deviation of each coordinate [m] (0.5 in)
constexpr double kBaseTurn = 0.5 * 0.017453292519943295;  // standard deviation about each axis [rad] (0.5 deg)

CampaignFile findDesign(const SimulationRequest& request, const Cell& cell) {
  const bool has_sheet = cell.sheet.has_value();
  if (const auto* named = calibration::findCampaignDesign(request.design))
    return {named->make(has_sheet), std::nullopt};
  std::error_code error;
  const auto extension = std::filesystem::path(request.design).extension();
  if (extension == ".yaml" || extension == ".yml" || std::filesystem::exists(request.design, error))
    return readCampaignFile(request.design, cell.arm, cell.units, has_sheet);
  std::vector<std::string> names;
  for (const auto& named : calibration::campaignDesigns()) names.emplace_back(named.name);
  const std::string near = suggestion(request.design, names);
  names.emplace_back("a design file (.yaml)");
  throw InputError("--design", "the unknown design " + inQuotes(request.design), alternatives(names), near);
}

void checkNotNegative(const std::string& option, double value, const std::string& expected) {
  if (!(value >= 0) || !std::isfinite(value)) throw InputError(option, fmt::format("{}", value), expected);
}

void applyOptions(const SimulationRequest& request, const Units& units, CampaignDesign& design) {
  if (!request.loads.empty()) design.loads.clear();
  for (const double load : request.loads) {
    checkNotNegative("--loads", load, fmt::format("weights of zero or more, in {}", units.force().name));
    design.loads.push_back(units.toInternal(load, dimension::kForce));
  }
  if (request.sigma) {
    checkNotNegative("--sigma", *request.sigma, fmt::format("a length of zero or more, in {}", units.length().name));
    design.sigma = units.toInternal(*request.sigma, dimension::kLength);
    design.sigma_W.reset();
    design.correlation_W.reset();
  }
  if (request.push) {
    checkNotNegative("--push", *request.push, fmt::format("a force of zero or more, in {}", units.force().name));
    design.push = units.toInternal(*request.push, dimension::kForce);
  }
  if (!request.held_out) return;
  if (!(*request.held_out >= 0 && *request.held_out < 1))
    throw InputError("--held-out", fmt::format("{}", *request.held_out), "a fraction from 0 to below 1");
  design.held_out = *request.held_out;
}

int countMeasurements(const SimulationRequest& request, const CampaignFile& file) {
  const std::string expected = fmt::format("a whole number from 1 to {}", kMostMeasurements);
  if (!request.measurements && !file.postures)
    throw InputError("--readings", "nothing", expected, "add --readings N, or `postures` to the design file");
  const auto measurements =
      request.measurements
          ? *request.measurements
          : *file.postures * static_cast<std::int64_t>(calibration::measurementsPerPosture(file.design));
  if (measurements < 1 || measurements > kMostMeasurements)
    throw InputError(request.measurements ? "--readings" : request.design, fmt::format("{} readings", measurements),
                     fmt::format("1 to {} readings", kMostMeasurements));
  return static_cast<int>(measurements);
}

void requireHoles(const Cell& cell, const CampaignDesign& design) {
  if (design.place != CampaignPlace::kHoles) return;
  (void)requireSheet(cell, "measure at its holes");
  requireToolAxis(cell, "measure at holes");
}

std::vector<calibration::CampaignPoint> openHoles(const Cell& cell) {
  std::vector<calibration::CampaignPoint> holes;
  if (!cell.sheet) return holes;
  for (const auto& tube : cell.sheet->tubes)
    if (tube.state == tubesheets::TubeState::kOpen)
      holes.push_back({tubesheets::tubeName(tube.row, tube.column), planner::holeCentre(tube)});
  return holes;
}

BaseError baseErrorOf(const SimulationRequest& request, const Cell& cell, const CampaignDesign& design) {
  if (cell.base_known && !request.base_error.empty())
    throw InputError::problem("--base-error", "the base of the cell is known, so it has no error",
                              "write base: {..., known: false} in " + cell.path);
  if (cell.base_known && design.setups > 1)
    throw InputError::problem(
        cell.path,
        fmt::format("the base is known, but each of the {} set-ups has a base pose of its own", design.setups),
        "write base: {..., known: false}");
  if (cell.base_known) return {};
  if (request.base_error.empty()) return {kBaseShift, kBaseTurn};
  if (request.base_error.size() != 2)
    throw InputError("--base-error", fmt::format("{} numbers", request.base_error.size()), "two: LENGTH,ANGLE");
  for (const double error : request.base_error)
    checkNotNegative("--base-error", error, "LENGTH,ANGLE, both zero or more");
  return {cell.units.toInternal(request.base_error[0], dimension::kLength),
          cell.units.toInternal(request.base_error[1], dimension::kAngle)};
}

/// Returns the effect with a magnitude that is typical of real machines: a fifth of the plausible maximum.
deflection::Effect ofTypicalSize(deflection::Effect effect) {
  const auto& kind = deflection::effectKinds().at(static_cast<std::size_t>(effect.kind));
  for (std::size_t v = 0; v < effect.values.size(); ++v)
    if (!kind.parameters[v].is_shape)
      effect.values[v] = kind.parameters[v].neutral + 0.2 * kind.parameters[v].plausible;
  return effect;
}

/// Returns the true arm and base poses, including effects and errors that the cell does not contain.
calibration::CampaignTruth makeTruth(const SimulationRequest& request, const Cell& cell, const CampaignDesign& design,
                                     const BaseError& base) {
  checkNotNegative("--spread", request.spread, "a fraction of zero or more, which applies to every stiffness");
  if (request.spread > 1) throw InputError("--spread", fmt::format("{}", request.spread), "a fraction up to 1");
  calibration::TruthOptions truth;
  truth.parameters = identifiedParameters(cell);
  if (request.spread > 0 && truth.parameters.empty())
    throw InputError::problem(cell.path, "there are no parameters under `identify`, which --spread needs",
                              "list the parameters there");
  truth.spread = request.spread;
  truth.base_shift_sigma = base.shift;
  truth.base_turn_sigma = base.turn;
  truth.setups = design.setups;
  truth.seed = request.seed;
  calibration::CampaignTruth drawn = calibration::drawTruth(cell.arm, cell.X_WB, truth);
  for (const std::string& text : request.hide) {
    const auto parsed = parseEffect(text, cell.arm, cell.units, "--hide");
    drawn.arm.effects.push_back(parsed.has_sizes ? parsed.effect : ofTypicalSize(parsed.effect));
  }
  return drawn;
}

/// Sets the number of inserted steps in measurements from the offset and the tilt of the true arm's tool; removes
/// measurements in which no step enters, because they carry no information.
void countSteps(const Cell& cell, const calibration::CampaignTruth& truth,
                std::vector<calibration::Measurement>& measurements) {
  for (auto& measurement : measurements) {
    const auto base = std::ranges::find(truth.bases, measurement.setup, &calibration::TrueBase::setup);
    const auto axis = calibration::toolAxisAt(truth.arm, base->X_WB, measurement);
    const bool is_upward = axis && axis->isUpward();
    measurement.kind_values[0] =
        is_upward ? tubesheets::stepsInserted(*cell.tool, measurement.kind_values.tail<2>(), axis->lean()) : 0;
  }
  std::erase_if(measurements, [](const auto& measurement) { return measurement.kind_values[0] == 0; });
  settleSteps(measurements, cell, "simulated visits");
}

}  // namespace

SimulationTask prepareSimulation(const Cell& cell, const SimulationRequest& request) {
  CampaignFile file = findDesign(request, cell);
  applyOptions(request, cell.units, file.design);
  SimulationTask task;
  task.measurements = countMeasurements(request, file);
  task.design = file.design;
  if (const auto problem = calibration::findDesignProblem(task.design, task.measurements); !problem.empty())
    throw InputError::problem("--design " + request.design, problem, "see `tubeplan simulate --help`");
  requireHoles(cell, task.design);
  if (kindOf(task.design.kind).counts_steps) (void)requireTool(cell, "count its steps");
  task.base = baseErrorOf(request, cell, task.design);
  task.truth = makeTruth(request, cell, task.design, task.base);
  return task;
}

calibration::SimulatedCampaign simulateMeasurements(const Cell& cell, const SimulationTask& task, std::uint64_t seed,
                                                    const calibration::CampaignHooks& hooks) {
  const CampaignDesign& design = task.design;
  calibration::CampaignOptions campaign;
  campaign.measurements = task.measurements;
  campaign.seed = seed;
  campaign.holes = openHoles(cell);
  campaign.hole_axis_W = planner::kHoleAxis_W;
  const bool touches_holes = kindOf(design.kind).is_centring && design.place == CampaignPlace::kHoles;
  campaign.is_clear = clearanceOf(cell, task.truth, touches_holes);
  auto simulated = calibration::simulateCampaign(task.truth, design, campaign, hooks);
  if (kindOf(design.kind).counts_steps) countSteps(cell, task.truth, simulated.measurements);
  return simulated;
}

}  // namespace tubeplan::app
