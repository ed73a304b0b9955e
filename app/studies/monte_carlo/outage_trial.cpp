#include "app/studies/monte_carlo/outage_trial.hpp"

#include <algorithm>
#include <limits>

#include "calibration/measurements/counted_section.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::app {

using calibration::HiddenChange, calibration::Measurement, calibration::TrueState;

namespace {

using OutageDraw = calibration::RandomStreamFrom<SplitMix>;

/// Purpose of random numbers, as a part of their key; those of CentringTrials are smaller.
enum OutagePurpose : std::uint64_t { kChangeKey = 201, kDirectionKey, kReadingKey };

/// Smallest number of visits of a run. A change begins after the first fifth of them and before the last three tenths.
constexpr std::size_t kLeastVisits = 10;

const HiddenChange& changeAt(int index) { return calibration::hiddenChanges()[static_cast<std::size_t>(index)]; }

/// Steps that enter at a visit of the true arm, whose joints differ from their readings by encoder noise; std::nullopt
/// if its shape does not converge.
std::optional<int> stepsOf(const TrueState& now, Measurement visit, const Eigen::Vector3d& tip_error_W,
                           const tubesheets::SteppedTool& tool, OutageDraw& draw) {
  for (Eigen::Index j = 0; j < visit.q.size(); ++j) visit.q[j] += draw.normal(now.arm.joint(j).encoder_sigma);
  const auto at = calibration::toolAt(now.arm, now.X_WB, visit);
  const auto axis = calibration::toolAxisAt(now.arm, now.X_WB, visit);
  if (!at || !axis) return std::nullopt;
  const Eigen::Vector3d offset = at->p_W + tip_error_W - *visit.p_W;
  return tubesheets::stepsInserted(tool, offset.head<2>(), axis->lean());
}

bool isTrueAnswer(const calibration::ChangeAnswer& answer, const HiddenChange& change, const deflection::Arm& arm) {
  return answer.effect == change.effect && answer.at == change.at(arm) &&
         (change.is_ramp ? answer.may_be_ramp : answer.may_be_step);
}

}  // namespace

OutageTrials::OutageTrials(const planner::Workcell& model, const planner::Workcell& truth, const CentringHoles& holes,
                           const OutageOptions& options)
    : options_(options), tool_(model.tool), trials_(model, truth, holes, options.centring) {}

/// Returns the visits that the calibrated model can steer to. Each is followed by the one whose posture is nearest, by
/// the largest change of a joint.
std::vector<OutageTrials::Visit> OutageTrials::visitsInOrder(const CalibratedRun& run) {
  std::vector<Eigen::Vector3d> places;
  std::vector<Eigen::VectorXd> starts;
  for (const auto& hole : run.visited) {
    places.push_back(hole.plan.p_WH);
    starts.push_back(hole.plan.q_start);
  }
  const auto& base = run.base.flexible;
  const auto found =
      calibration::reachPlaces(base.arm, base.X_WB, places, starts, run.truth.load, Eigen::Vector3d::UnitZ());
  std::vector<Visit> visits;
  for (std::size_t k = 0; k < found.size(); ++k)
    if (found[k].status == deflection::BranchStatus::kConverged) visits.push_back({run.visited[k], found[k].q});
  for (std::size_t k = 1; k < visits.size(); ++k) {
    const Eigen::VectorXd& q = visits[k - 1].q;
    const auto distance = [&](const Visit& visit) { return (visit.q - q).cwiseAbs().maxCoeff(); };
    std::swap(visits[k],
              *std::ranges::min_element(visits.begin() + static_cast<std::ptrdiff_t>(k), visits.end(), {}, distance));
  }
  return visits;
}

std::optional<Measurement> OutageTrials::read(const Visit& visit, bool is_touch, const CalibratedRun& run,
                                              const TrueState& now, std::uint64_t key) const {
  OutageDraw draw(key);
  if (!is_touch) {
    Measurement reading = calibration::plannedTouch(visit.hole.plan, visit.q, run.truth.load, calibration::kVisitSigma);
    reading.kind = calibration::MeasurementKind::kSteps;
    const auto steps = stepsOf(now, reading, visit.hole.tip_error, tool_, draw);
    if (!steps) return std::nullopt;
    reading.kind_values[0] = *steps;
    return reading;
  }
  const double sigma = options_.centring.settings.front().touch_sigma;
  planner::Workcell truth = run.truth;
  truth.arm = now.arm;
  truth.X_WB = now.X_WB;
  auto touches = touchHoles(truth, {visit.hole}, 1, sigma, draw.seed());
  if (touches.empty()) return std::nullopt;
  touches.front().sigma = std::max(sigma, kLeastWeighingSigma);
  return touches.front();
}

OutageTrials::Hidden OutageTrials::hiddenIn(const CalibratedRun& run, std::uint64_t index, std::size_t visits) const {
  OutageDraw draw(keyOf({options_.centring.seed, index, kChangeKey}));
  OutageDraw directions(keyOf({options_.centring.seed, index, kDirectionKey}));
  const auto direction = [&] { return Eigen::Vector3d(directions.vector(1).normalized()); };
  Hidden hidden{0, visits, {}};
  if (draw.uniform(0, 1) >= options_.nothing) {
    hidden.change = options_.changes[static_cast<std::size_t>(draw.index(static_cast<int>(options_.changes.size())))];
    hidden.since = visits / 5 + static_cast<std::size_t>(draw.index(static_cast<int>(visits / 2)));
  }
  hidden.changed = changeAt(hidden.change).make({run.truth.arm, run.truth.X_WB}, direction);
  return hidden;
}

OutageTrials::Readings OutageTrials::readings(const std::vector<Visit>& visits, const CalibratedRun& run,
                                              std::uint64_t index, const Hidden& hidden) const {
  const TrueState before{run.truth.arm, run.truth.X_WB};
  Readings readings;
  for (std::size_t k = 0; k < visits.size(); ++k) {
    const bool is_touch = options_.touch_every > 0 && (k + 1) % static_cast<std::size_t>(options_.touch_every) == 0;
    const TrueState now = k < hidden.since ? before : hidden.changed(static_cast<int>(k - hidden.since + 1));
    auto reading = read(visits[k], is_touch, run, now, keyOf({options_.centring.seed, index, kReadingKey, k}));
    if (!reading) continue;
    readings.since += k < hidden.since;
    readings.list.push_back(std::move(*reading));
    readings.list.back().id = "V" + std::to_string(k + 1);
  }
  return readings;
}

CountedVisits OutageTrials::counted(const Readings& readings, std::size_t first, std::size_t end) const {
  CountedVisits counted;
  for (std::size_t k = first; k < std::min(end, readings.list.size()); ++k) {
    const Measurement& reading = readings.list[k];
    if (reading.kind != calibration::MeasurementKind::kSteps) continue;
    ++counted.visits;
    counted.all_steps += reading.kind_values[0] == static_cast<double>(tool_.steps.size());
  }
  return counted;
}

void OutageTrials::judge(const calibration::Watch& watch, const Readings& readings, const deflection::Arm& arm,
                         OutageTrial& trial) const {
  trial.is_watched = true;
  trial.is_alarm = watch.alarm.has_value();
  const auto at = trial.is_alarm ? static_cast<std::size_t>(watch.alarm->measurement) : readings.list.size();
  trial.before = counted(readings, 0, readings.since);
  trial.is_early = trial.is_alarm && trial.change != 0 && at < readings.since;
  if (trial.is_early || trial.change == 0) return;
  trial.after = counted(readings, readings.since, at + 1);
  if (!trial.is_alarm) return;
  trial.delay = at - readings.since + 1;
  const auto& answers = watch.alarm->judgement.answers;
  trial.is_named = std::ranges::any_of(
      answers, [&](const auto& answer) { return isTrueAnswer(answer, changeAt(trial.change), arm); });
  trial.is_only_answer = trial.is_named && answers.size() == 1;
}

std::optional<OutageTrial> OutageTrials::run(std::uint64_t index, const calibration::StopQuestion& stop) const {
  const CalibratedRun run = trials_.calibrate(index);
  OutageTrial trial;
  // The rigid model steers to no visit, so its calibration may fail.
  if (run.failure != TrialFailure::kRigidRefused) trial.failure = run.failure;
  if (trial.failure != TrialFailure::kNone) return trial;
  const auto visits = visitsInOrder(run);
  if (visits.size() < kLeastVisits) return trial;
  const Hidden hidden = hiddenIn(run, index, visits.size());
  trial.change = hidden.change;
  const Readings readings = this->readings(visits, run, index, hidden);
  calibration::WatchOptions watching;
  watching.false_alarms = options_.false_alarms;
  watching.finds_means = false;
  watching.stop = stop;
  const auto& base = run.base.flexible;
  const auto watch = calibration::watchForChange(
      {base.arm, base.X_WB, base.uncertainty, options_.centring.additional.model_error, tool_}, readings.list,
      watching);
  if (watch.status == calibration::WatchStatus::kStopped) return std::nullopt;
  if (watch.status != calibration::WatchStatus::kNotComputed) judge(watch, readings, run.truth.arm, trial);
  return trial;
}

}  // namespace tubeplan::app
