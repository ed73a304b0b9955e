#include "app/studies/monte_carlo/centring_trial.hpp"

#include <algorithm>
#include <cassert>

#include "app/studies/measurements/simulated_calibration.hpp"

namespace tubeplan::app {

namespace {

using calibration::CalibrationStatus, calibration::TouchPlan;
using Draw = calibration::RandomStreamFrom<SplitMix>;

/// Purpose of random numbers, as a part of their key. With separate keys, the random numbers of one quantity stay the
/// same when more numbers are drawn for another.
enum Purpose : std::uint64_t { kTruthKey = 1, kVisitedKey, kTouchedKey, kTipErrorKey, kNoiseKey };

constexpr std::array kRules{
    TouchRuleRow{TouchRule::kBest, "best",
                 "those with the smallest predicted base covariance, as `plan --touches auto`"},
    TouchRuleRow{TouchRule::kSpread, "spread", "those farthest from each other"},
    TouchRuleRow{TouchRule::kRandom, "random", "drawn at random in every run"},
    TouchRuleRow{TouchRule::kTested, "tested", "drawn from the holes that are visited, as `score --runs`"}};

/// Returns the workcell without its sheet and scene, which are large and not needed by any run.
planner::Workcell armOnly(planner::Workcell cell) {
  cell.sheet = {};
  cell.scene = {};
  return cell;
}

/// Returns holes chosen by farthest-point sampling: first the hole farthest from the centroid, then repeatedly the hole
/// farthest from all holes chosen before.
std::vector<TouchPlan> farthestPointSample(const std::vector<TouchPlan>& plans, int count) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& plan : plans) middle += plan.p_WH / static_cast<double>(plans.size());
  std::vector<TouchPlan> chosen;
  const auto distance = [&](const TouchPlan& plan) {
    double least = chosen.empty() ? (plan.p_WH - middle).norm() : std::numeric_limits<double>::infinity();
    for (const auto& other : chosen) least = std::min(least, (plan.p_WH - other.p_WH).norm());
    return least;
  };
  while (static_cast<int>(chosen.size()) < count)
    chosen.push_back(*std::max_element(plans.begin(), plans.end(),
                                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); }));
  return chosen;
}

double meanResidual(const calibration::BaseCalibration& base) {
  double sum = 0;
  for (const auto& residual : base.residuals) sum += residual.residual_W.norm();
  return sum / static_cast<double>(base.residuals.size());
}

TrialFailure failureOf(const BothCalibrations& base) {
  if (base.flexible.status == CalibrationStatus::kRefused) return TrialFailure::kMistakenHole;
  if (base.flexible.status != CalibrationStatus::kDone) return TrialFailure::kNotConverged;
  return base.rigid.status == CalibrationStatus::kDone ? TrialFailure::kNone : TrialFailure::kRigidRefused;
}

}  // namespace

std::span<const TouchRuleRow> touchRules() { return kRules; }

std::string_view nameOf(TrialFailure failure) {
  switch (failure) {
    case TrialFailure::kNone:
      return "scored";
    case TrialFailure::kTooNarrow:
      return "only nearly collinear holes were drawn";
    case TrialFailure::kUntouchable:
      return "the true arm cannot touch one of the holes";
    case TrialFailure::kMistakenHole:
      return "the touches were rejected: a hole name seems wrong";
    case TrialFailure::kNotConverged:
      return "the base could not be found";
    case TrialFailure::kRigidRefused:
      return "the rigid model's base could not be found";
  }
  return "";
}

struct CentringTrials::Run {
  std::uint64_t index;
  planner::Workcell truth;
};

CentringTrials::CentringTrials(const planner::Workcell& model, const planner::Workcell& truth,
                               const CentringHoles& holes, const CentringOptions& options)
    : options_(options),
      flexible_(model.arm),
      rigid_(deflection::rigidCopy(model.arm)),
      X_WB_(model.X_WB),
      truths_(armOnly(truth), options.spread),
      sheet_(model.sheet),
      holes_(prepared(holes.visited)) {
  assert(static_cast<int>(holes_.size()) >= options.holes);
  for (const auto& setting : options.settings) fixed_.push_back(fixedHoles(model, holes, setting));
}

std::vector<CentringTrials::Hole> CentringTrials::prepared(const std::vector<TouchPlan>& plans) const {
  std::vector<Hole> holes;
  for (const auto& plan : plans) holes.push_back({plan, tubeOf(plan, sheet_)});
  return holes;
}

std::vector<CentringTrials::Hole> CentringTrials::fixedHoles(const planner::Workcell& model, const CentringHoles& holes,
                                                             const CentringSetting& setting) {
  if (setting.rule == TouchRule::kBest) {
    const BestTouches best = bestTouches(model, holes.touchable, setting.touches, options_.additional);
    if (problem_.empty()) problem_ = best.reason;
    return prepared(best.plans);
  }
  if (setting.rule == TouchRule::kSpread) return prepared(farthestPointSample(holes.visited, setting.touches));
  return {};
}

std::vector<std::string> CentringTrials::touchedHoles(std::size_t setting) const {
  std::vector<std::string> names;
  for (const auto& hole : fixed_[setting]) names.push_back(hole.plan.hole);
  return names;
}

std::vector<Trial> CentringTrials::run(std::uint64_t index) const {
  const Run run = drawnRun(index);
  std::vector<Trial> trials;
  for (std::size_t k = 0; k < options_.settings.size(); ++k) trials.push_back(runSetting(run, k));
  return trials;
}

CentringTrials::Run CentringTrials::drawnRun(std::uint64_t index) const {
  Draw draw(keyOf({options_.seed, index, kTruthKey}));
  return {index, truths_.draw(draw)};
}

CalibratedRun CentringTrials::calibrate(std::uint64_t index, std::size_t setting) const {
  Run run = drawnRun(index);
  Calibrated calibrated = this->calibrated(run, setting);
  CalibratedRun result{calibrated.failure, std::move(run.truth), std::move(calibrated.base), {}};
  for (const Hole* hole : calibrated.visited) result.visited.push_back(trialHole(*hole, index));
  return result;
}

TrialHole CentringTrials::trialHole(const Hole& hole, std::uint64_t run) const {
  Draw draw(keyOf({options_.seed, run, kTipErrorKey, static_cast<std::uint64_t>(hole.tube)}));
  return {hole.plan, hole.tube, draw.vector(options_.spread.unmodelled_sigma)};
}

/// Draws `count` holes at random, and repeats the draw until the first `well_spread` holes are far from collinear.
/// Returns no holes if kMostDraws draws fail.
std::vector<const CentringTrials::Hole*> CentringTrials::drawnHoles(std::uint64_t key, int count,
                                                                    int well_spread) const {
  Draw draw(key);
  std::vector<std::size_t> order(holes_.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  for (int tries = 0; tries < kMostDraws; ++tries) {
    draw.choose(order, static_cast<std::size_t>(count));
    std::vector<const Hole*> holes;
    std::vector<TrialHole> first;
    for (int k = 0; k < count; ++k) {
      holes.push_back(&holes_[order[static_cast<std::size_t>(k)]]);
      if (k < well_spread) first.push_back({holes.back()->plan, holes.back()->tube});
    }
    if (well_spread == 0 || areWellSpread(first, well_spread)) return holes;
  }
  return {};
}

CentringTrials::Calibrated CentringTrials::calibrated(const Run& run, std::size_t index) const {
  const auto& setting = options_.settings[index];
  const bool is_tested = setting.rule == TouchRule::kTested;
  Calibrated result;
  auto& visited = result.visited;
  visited = drawnHoles(keyOf({options_.seed, run.index, kVisitedKey}), options_.holes, is_tested ? setting.touches : 0);
  std::vector<const Hole*> touched;
  if (is_tested)
    touched.assign(visited.begin(), visited.begin() + std::min<std::ptrdiff_t>(setting.touches, std::ssize(visited)));
  else if (setting.rule == TouchRule::kRandom)
    touched = drawnHoles(keyOf({options_.seed, run.index, kTouchedKey}), setting.touches, setting.touches);
  else
    for (const auto& hole : fixed_[index]) touched.push_back(&hole);
  if (touched.empty() || visited.empty()) {
    result.failure = TrialFailure::kTooNarrow;
    return result;
  }
  const auto touches = touch(run, touched, setting);
  if (touches.empty()) {
    result.failure = TrialFailure::kUntouchable;
    return result;
  }
  result.base = calibrateBoth(flexible_, rigid_, options_.additional, X_WB_, sheet_, touches);
  result.failure = failureOf(result.base);
  return result;
}

Trial CentringTrials::runSetting(const Run& run, std::size_t index) const {
  const Calibrated calibrated = this->calibrated(run, index);
  Trial trial;
  trial.failure = calibrated.failure;
  if (trial.failure != TrialFailure::kNone) return trial;
  trial.touch_error = meanResidual(calibrated.base.flexible);
  trial.is_misfit = calibration::isFitRefused(calibrated.base.flexible);
  trial.visits = visit(run, calibrated.visited, calibrated.base);
  return trial;
}

std::vector<calibration::Measurement> CentringTrials::touch(const Run& run, const std::vector<const Hole*>& holes,
                                                            const CentringSetting& setting) const {
  std::vector<TrialHole> trial_holes;
  for (const Hole* hole : holes) trial_holes.push_back(trialHole(*hole, run.index));
  auto touches = touchHoles(run.truth, trial_holes, static_cast<int>(holes.size()), setting.touch_sigma,
                            keyOf({options_.seed, run.index, kNoiseKey}));
  for (auto& touch : touches) touch.sigma = std::max(touch.sigma, kLeastWeighingSigma);
  return touches;
}

std::vector<TrialVisit> CentringTrials::visit(const Run& run, const std::vector<const Hole*>& holes,
                                              const BothCalibrations& base) const {
  std::vector<HoleToScore> to_score;
  for (const Hole* hole : holes)
    to_score.push_back({hole->plan.p_WH, hole->plan.q_start, trialHole(*hole, run.index).tip_error});
  planner::TipPrediction true_tips(run.truth);
  const auto rigid = centringsAt({rigid_, base.rigid.X_WB}, run.truth, true_tips, to_score);
  const auto flexible = centringsAt({base.flexible.arm, base.flexible.X_WB}, run.truth, true_tips, to_score);
  std::vector<TrialVisit> visits;
  for (std::size_t k = 0; k < holes.size(); ++k)
    visits.push_back({static_cast<int>(holes[k] - holes_.data()), {rigid[k], flexible[k]}});
  return visits;
}

}  // namespace tubeplan::app
