#include "app/formats/sheet/touch_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>

#include "app/formats/measurements/measurements_writer.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "calibration/measurements/counted_section.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/simulation/simulated_touch.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

namespace {

using calibration::Measurement;

double sigmaOf(const Measurement& measurement, const Cell& cell, const std::string& file) {
  if (std::isfinite(measurement.sigma)) return measurement.sigma;
  if (cell.tool) return touchSigmaOf(*cell.tool);
  throw InputError::problem(fmt::format("{}:{}", file, measurement.line),
                            "the touch has no sigma, which states its centring noise",
                            "add a column sigma_" + std::string(cell.units.length().name));
}

/// Throws InputError if a touch states the name of one hole and the position of another.
void requireNamedHole(const Measurement& measurement, const Cell& cell, const std::string& file) {
  const auto name = tubesheets::parseTubeName(measurement.point);
  const auto* tube = name && cell.sheet ? cell.sheet->find(name->row, name->column) : nullptr;
  if (!tube || (*measurement.p_W - planner::holeCentre(*tube)).norm() < cell.sheet->pitch / 4) return;
  throw InputError::problem(fmt::format("{}:{}", file, measurement.line),
                            "the coordinates are not those of hole " + measurement.point + " on the sheet",
                            "correct the name or the coordinates");
}

void requireOneSetup(const std::vector<Measurement>& measurements, const std::string& file, const std::string& setup) {
  std::set<std::string> setups;
  for (const auto& measurement : measurements)
    if (isTouch(measurement)) setups.insert(measurement.setup);
  if (!setup.empty() && !setups.contains(setup)) {
    std::vector<std::string> known;
    for (const auto& name : setups) known.push_back(inQuotes(name));
    throw InputError::problem("--setup", file + " has no touch of the set-up " + inQuotes(setup),
                              known.empty() ? "" : fmt::format("its set-ups are {}", fmt::join(known, ", ")));
  }
  if (setup.empty() && setups.size() > 1)
    throw InputError::problem(
        file, fmt::format("the touches come from {} set-ups, each with its own base pose", setups.size()),
        "choose one set-up with --setup");
}

}  // namespace

void settleSteps(std::vector<Measurement>& measurements, const Cell& cell, const std::string& file, bool takes_none) {
  const tubesheets::SteppedTool& tool = *cell.tool;
  const auto most = static_cast<double>(tool.steps.size());
  for (auto& measurement : measurements) {
    if (!kindOf(measurement).counts_steps) continue;
    const double steps = measurement.kind_values[0];
    const int fewest = takes_none ? 0 : 1;
    if (!(steps >= fewest && steps <= most) || steps != std::round(steps))
      throw InputError(
          fmt::format("{}:{}", file, measurement.line), fmt::format("{} steps", steps),
          fmt::format("{} to {}, the number of steps that the tool has", fewest, tool.steps.size()),
          steps == 0 ? "leave the visit out, because a visit with no step inserted sets no bound on the centring error"
                     : "");
    calibration::settleCount(measurement, tool, cell.arm, cell.X_WB);
  }
}

std::vector<Measurement> touchesOf(const std::vector<Measurement>& measurements, const Cell& cell,
                                   const std::string& file, const std::string& setup) {
  requireOneSetup(measurements, file, setup);
  std::vector<Measurement> touches;
  for (const auto& measurement : measurements) {
    if (!touchesKnownPoint(measurement) || (!setup.empty() && measurement.setup != setup)) continue;
    requireNamedHole(measurement, cell, file);
    touches.push_back(measurement);
    if (measurement.point.empty()) touches.back().point = measurement.id;
    touches.back().sigma = sigmaOf(measurement, cell, file);
  }
  if (touches.empty())
    throw InputError::problem(file, "no reading is a touch of a known hole",
                              "add rows of kind touch with a hole's name (R10C20) or x, y, z");
  return touches;
}

std::vector<calibration::TouchPlan> requireTouches(BestTouches touches) {
  if (!touches.reason.empty())
    throw InputError::problem("--touches auto", touches.reason, "check base, scene and joint limits of the cell");
  return std::move(touches.plans);
}

std::vector<Measurement> touchesByTrueArm(const planner::Workcell& model, const Cell& cell,
                                          const planner::Workcell& truth, std::uint64_t seed) {
  constexpr int kCandidates = 24, kTouches = 3;
  const auto plans =
      requireTouches(bestTouches(model, touchCandidates(model, kCandidates), kTouches, additionalUncertainty(cell)));
  calibration::TouchSimulationOptions options;
  options.sigma = touchSigmaOf(model.tool);
  options.load = truth.load;
  options.seed = seed;
  auto simulation = calibration::simulateTouches(truth.arm, truth.X_WB, plans, options);
  if (simulation.status != calibration::TouchSimulationStatus::kDone)
    throw InputError::problem("--touches auto", simulation.reason, "give touches in a file");
  return std::move(simulation.touches);
}

void requireEnoughTouches(const std::vector<Measurement>& touches, const std::string& file) {
  if (const auto problem = calibration::findTouchProblem(touches); !problem.empty())
    throw InputError::problem(file, problem, "touch three or more different holes, well spread");
}

std::string touchesCsv(const std::vector<Measurement>& touches, const Cell& cell) {
  return measurementsCsv(touches, cell.arm, cell.units);
}

}  // namespace tubeplan::app
