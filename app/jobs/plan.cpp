#include "app/jobs/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "app/documents/plan_outcome.hpp"
#include "app/documents/segments_warning.hpp"
#include "app/formats/cell/command_inputs.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/formats/sheet/touched_base.hpp"
#include "app/formats/units.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/positioning/planned_visits.hpp"
#include "app/studies/positioning/row_deviations.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

planner::Compensation compensationOf(const std::string& name) {
  if (const auto mode = planner::findCompensation(name)) return *mode;
  throw InputError("--compensation", inQuotes(name), "none, goal-point or via-point");
}

planner::TravelKind travelOf(const PlanRequest& request) {
  const auto kind = planner::findTravelKind(request.travel);
  if (!kind) throw InputError("--travel", inQuotes(request.travel), "joints or line");
  if (*kind == planner::TravelKind::kLine && request.compensation != planner::nameOf(planner::Compensation::kViaPoint))
    throw InputError::problem("--travel line",
                              "this travel needs the compensation via-point, not " + request.compensation,
                              "only via points solved on the flexible model keep the tip on a straight line");
  return *kind;
}

void requireSameSheet(const planner::Workcell& cell, const planner::Workcell& truth, const std::string& file) {
  if (cell.sheet.fingerprint() != truth.sheet.fingerprint())
    throw InputError::problem(
        file,
        fmt::format("this tube sheet (fingerprint {}) differs from that of the cell (fingerprint {})",
                    truth.sheet.fingerprint(), cell.sheet.fingerprint()),
        "give a --truth cell with the same tube sheet");
}

std::vector<calibration::Measurement> touchesFor(const PlanRequest& request, const PlanOutcome& outcome) {
  if (request.touches == "auto" && !outcome.truth)
    throw InputError::problem("--touches auto", "simulated touches need a true arm, but none is given",
                              "give its cell with --truth CELL, or give a file of touches");
  if (request.touches == "auto") return touchesByTrueArm(outcome.nominal, outcome.cell, *outcome.truth, request.seed);
  const auto measurements = readMeasurements(request.touches, outcome.cell.arm, &outcome.nominal.sheet);
  requireDefinedFormulas(measurements, outcome.cell, request.touches);
  const auto touches = touchesOf(measurements, outcome.cell, request.touches);
  requireEnoughTouches(touches, request.touches);
  return touches;
}

void countChanges(const std::vector<int>& before, PlanOutcome& outcome) {
  const std::set<int> old(before.begin(), before.end());
  int kept = 0;
  for (const auto& visit : outcome.plan.visits) kept += old.contains(visit.tube);
  outcome.tubes_added = static_cast<int>(outcome.plan.visits.size()) - kept;
  outcome.tubes_removed = static_cast<int>(old.size()) - kept;
}

constexpr double kMostStandoff = 1;  // largest standoff and largest insertion [m]

double standoffOf(const PlanRequest& request, const PlanOutcome& outcome) {
  if (!request.standoff) return planner::CompensationOptions{}.standoff;
  const double standoff = outcome.cell.units.toInternal(*request.standoff, dimension::kLength);
  if (!(standoff > 0 && standoff <= kMostStandoff))
    throw InputError(
        "--standoff", fmt::format("{}", *request.standoff),
        "a length above zero, at most " +
            fmt::format("{:.3g} {}", lengthOf(kMostStandoff, outcome.cell.units), outcome.cell.units.length().name));
  return standoff;
}

double insertionOf(const PlanRequest& request, const Units& units) {
  const double insertion = units.toInternal(request.insertion, dimension::kLength);
  if (!(insertion >= 0 && insertion <= kMostStandoff))
    throw InputError("--insertion", fmt::format("{}", request.insertion),
                     fmt::format("a depth from 0 to {:.3g} {}", lengthOf(kMostStandoff, units), units.length().name));
  return insertion;
}

planner::VisitPlanOptions planOptions(const PlanRequest& request, const PlanOutcome& outcome) {
  planner::VisitPlanOptions options;
  options.seed = request.seed;
  options.reach.compensation.mode = outcome.compensation;
  options.reach.compensation.standoff = standoffOf(request, outcome);
  if (request.has_least_standoff) options.reach.standoff_shares = {0.3, 0.35, 0.4, 0.5, 0.65, 0.8, 1};
  options.reach.padding = request.padding;
  options.travel = travelOf(request);
  options.conditions = outcome.conditions;
  return options;
}

/// Throws InputError unless the padding, the clearance added in standard deviations of the base pose, is from 0 to 10
/// and, if not 0, the base has a covariance.
void checkPadding(const PlanRequest& request, const PlanOutcome& outcome) {
  constexpr double kMostSigmas = 10;
  if (!(request.padding >= 0 && request.padding <= kMostSigmas))
    throw InputError("--padding", fmt::format("{}", request.padding),
                     "0 to 10, in standard deviations of the base pose");
  if (request.padding > 0 && outcome.model.base_covariance.isZero(0))
    throw InputError::problem("--padding", "the base pose has no covariance, because it was not calibrated",
                              "give --touches, or a cell that `calibrate` wrote");
}

void addTruth(const std::string& file, PlanOutcome& outcome) {
  outcome.truth = workcellOf(readCell(file), "score against it");
  outcome.truth->load = outcome.nominal.load;
  outcome.truth->insertion = outcome.nominal.insertion;
  requireSameSheet(outcome.nominal, *outcome.truth, file);
}

/// Returns an outcome with the nominal workcell and, if the request names a truth, the true workcell.
PlanOutcome begun(const Cell& cell, const PlanRequest& request) {
  PlanOutcome outcome;
  outcome.cell = cell;
  outcome.compensation = compensationOf(request.compensation);
  outcome.nominal = workcellOf(outcome.cell, "plan tube visits");
  requireSpeeds(outcome.cell);
  outcome.nominal.load = parseLoad(request.load, outcome.cell.units, "--load");
  outcome.nominal.insertion = insertionOf(request, outcome.cell.units);
  outcome.model = outcome.nominal;
  if (!request.truth.empty()) addTruth(request.truth, outcome);
  return outcome;
}

/// Throws InputError for a zone that contains none of the tubes to visit; such a zone probably belongs to another work
/// list.
void requireZonesOfTheList(const ConditionsRequest& conditions_request, const planner::VisitConditions& conditions,
                           const std::vector<int>& tubes) {
  for (std::size_t k = 0; k < conditions.zones.size(); ++k) {
    const auto isSelected = [&](int tube) { return std::binary_search(tubes.begin(), tubes.end(), tube); };
    if (std::none_of(conditions.zones[k].begin(), conditions.zones[k].end(), isSelected))
      throw InputError::problem("--first",
                                inQuotes(conditions_request.first[k]) + " is not among the tubes to be visited",
                                "choose tubes that are to be visited");
  }
}

/// Sets the selected tubes, their visit conditions and the warnings about the work list.
void addConditions(const PlanRequest& request, const tubesheets::Selection& selection, PlanOutcome& outcome) {
  outcome.conditions = conditionsOf(request.conditions, outcome.cell, selection.dwell);
  requireZonesOfTheList(request.conditions, outcome.conditions, selection.tube_indices);
  outcome.selection = selection;
  outcome.left_out = tubesheets::leftOutText(selection);
  for (auto& note : listNotes(selection)) outcome.cell.warnings.push_back(std::move(note));
  if (auto doubtful = tubesheets::doubtfulText(outcome.nominal.sheet, selection); !doubtful.empty())
    outcome.cell.warnings.push_back(std::move(doubtful));
}

/// Calibrates the base from the touches. Returns false if the calibration fails.
bool placeBase(PlanOutcome& outcome, std::vector<calibration::Measurement> touches) {
  outcome.touches = std::move(touches);
  outcome.calibration = calibrateBoth(outcome.nominal, outcome.cell, outcome.touches);
  if (outcome.calibration->flexible.status != calibration::CalibrationStatus::kDone) return false;
  outcome.model = withBase(outcome.nominal, outcome.calibration->flexible);
  return true;
}

/// Sets the start posture if the arm starts at a tube. Throws InputError unless an earlier plan visits that tube.
void startAtTube(const PlanRequest& request, const PlanCheckpoint* checkpoint, PlanOutcome& outcome) {
  const auto tube = startTubeOf(request.conditions, outcome.nominal.sheet);
  if (!tube) return;
  outcome.conditions.start = checkpoint ? checkpoint->postureAt(*tube) : std::nullopt;
  if (outcome.conditions.start) return;
  throw InputError::problem(
      "--start",
      fmt::format("no earlier plan visits {}, so the arm's posture there is not known", request.conditions.start),
      "write the arm's joint readings, --start=A,B,..., or give the folder of the plan that visits it");
}

/// Throws InputError if the arm starts in a posture that an earlier plan found for another model.
void requireSameModel(const PlanRequest& request, const PlanCheckpoint& checkpoint, const PlanOutcome& outcome) {
  if (checkpoint.modelDifferences().empty() || !startTubeOf(request.conditions, outcome.nominal.sheet)) return;
  throw InputError::problem("--start",
                            fmt::format("the earlier plan visits {}, but with {}", request.conditions.start,
                                        fmt::join(checkpoint.modelDifferences(), ", ")),
                            "write the arm's joint readings, --start=A,B,...");
}

void plan(const PlanRequest& request, const std::vector<int>& tubes, planner::PlanHooks hooks,
          PlanCheckpoint* checkpoint, PlanOutcome& outcome) {
  checkPadding(request, outcome);
  if (request.padding > 0)
    outcome.model.row_deviations =
        rowDeviations(outcome.model, jointUncertaintyOf(outcome.cell, outcome.model, outcome.placedBy()));
  planner::PlanCache forgotten;
  planner::PlanCache& cache = checkpoint ? checkpoint->cache() : forgotten;
  startAtTube(request, checkpoint, outcome);
  if (checkpoint) {
    checkpoint->begin(planKeyOf({outcome.cell, outcome.model, outcome.conditions, request.compensation,
                                 standoffOf(request, outcome), request.has_least_standoff, request.padding,
                                 request.seed, checkpoint->fromFingerprint(), travelOf(request)},
                                tubes),
                      tubes);
    requireSameModel(request, *checkpoint, outcome);
    if (checkpoint->savesProgress())
      hooks.keep = [checkpoint](const planner::PlanCache&) { checkpoint->saveNowAndThen(); };
  }
  const std::vector<int> order_before = cache.visiting_order;
  outcome.plan = planner::planVisits(outcome.model, tubes, planOptions(request, outcome), hooks, cache);
  if (outcome.plan.status != planner::VisitPlanStatus::kPlanned) return;
  if (!outcome.conditions.zones.empty()) outcome.zones = planner::zonesOf(cache.visiting_order, outcome.conditions);
  countChanges(order_before, outcome);
  if (auto warning = warningOf(outcome.standing()); !warning.empty())
    outcome.cell.warnings.push_back(std::move(warning));
  if (request.padding > 0) outcome.padding = paddingAtHoles(outcome.model, outcome.plan, request.padding);
  if (auto warning = segmentsWarning(outcome.cell, outcome.model, visitPostures(outcome.plan)); !warning.empty())
    outcome.cell.warnings.push_back(std::move(warning));
  outcome.predicted = predictVisits(outcome.model, outcome.plan);
  if (outcome.model.insertion > 0) outcome.play = playInTubes(outcome.model, outcome.plan);
  outcome.chances =
      stepChances({outcome.cell, outcome.model, outcome.placedBy(), visitPostures(outcome.plan), outcome.predicted});
  if (outcome.truth)
    outcome.scores = scoreVisitModes(scoringModels(outcome.nominal, outcome.calibration, *outcome.truth), outcome.plan);
}

}  // namespace

PlanOutcome runPlanJob(const PlanRequest& request, planner::PlanHooks hooks, PlanCheckpoint& checkpoint) {
  Cell cell = readCell(request.cell);
  if (!request.touches.empty()) forgetTouches(cell);
  PlanOutcome outcome = begun(cell, request);
  std::vector<std::string> lists = request.conditions.first;
  lists.push_back(request.tubes);
  requireWorkList(request.conditions.columns, lists);
  const auto selection = readTubes(request.tubes, outcome.nominal.sheet, request.conditions.columns);
  addConditions(request, selection, outcome);
  if (!request.touches.empty() && !placeBase(outcome, touchesFor(request, outcome))) return outcome;
  plan(request, selection.tube_indices, std::move(hooks), &checkpoint, outcome);
  return outcome;
}

PlanOutcome planCell(const Cell& cell, const PlanRequest& request, planner::PlanHooks hooks,
                     PlanCheckpoint* checkpoint) {
  PlanOutcome outcome = begun(cell, request);
  auto selection = tubesheets::selectTubes(outcome.nominal.sheet, request.tubes);
  if (selection.status != tubesheets::SelectionStatus::kSelected)
    throw InputError::problem("tubes", inQuotes(request.tubes) + " cannot be planned: " + selection.reason,
                              "name tubes of this sheet");
  for (const auto& [tube, dwell] : request.dwell_times)
    if (std::ranges::find(selection.tube_indices, tube) != selection.tube_indices.end()) selection.dwell[tube] = dwell;
  addConditions(request, selection, outcome);
  plan(request, selection.tube_indices, std::move(hooks), checkpoint, outcome);
  return outcome;
}

}  // namespace tubeplan::app
