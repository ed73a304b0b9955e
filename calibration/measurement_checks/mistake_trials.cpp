#include "calibration/measurement_checks/mistake_trials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/measurements/measurement_problems.hpp"
#include "calibration/random_stream.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kUsualTurn = 0.05;   // usual rotation of a base from its nominal place [rad]
constexpr double kUsualShift = 0.05;  // usual shift of a base from its nominal place, relative to the reach
constexpr std::size_t kQuickMeasurements = 40;

/// Returns the indices of the measurements to use: all of them, or at most `most`, drawn randomly with `seed`.
/// Measurements of one unknown point are drawn together.
std::vector<std::size_t> drawMeasurements(const std::vector<Measurement>& measurements, std::size_t most,
                                          std::uint64_t seed) {
  auto groups = groupsByPlace(measurements);
  std::vector<std::size_t> drawn;
  if (measurements.size() > most) RandomStream(seed).shuffle(groups);
  for (const auto& group : groups) {
    if (!drawn.empty() && drawn.size() + group.size() > most) continue;
    drawn.insert(drawn.end(), group.begin(), group.end());
  }
  std::ranges::sort(drawn);
  return drawn;
}

MeasurementPool poolOf(const std::vector<Measurement>& measurements, const CheckOptions& options) {
  MeasurementPool pool;
  std::set<std::size_t> kept;
  const auto drawn = drawMeasurements(measurements, options.most_measurements, options.seed);
  std::vector<Measurement> of_drawn;
  for (const std::size_t k : drawn) {
    pool.counted.insert(measurements[k].id);
    of_drawn.push_back(measurements[k]);
    for (const std::size_t near : {k - 1, k, k + 1})
      if (near < measurements.size()) kept.insert(near);
  }
  for (const std::size_t k : drawMeasurements(of_drawn, kQuickMeasurements, options.seed))
    pool.counted_quickly.insert(of_drawn[k].id);
  for (const std::size_t k : kept) {
    pool.measurements.push_back(measurements[k]);
    pool.measurements.back().is_held_out = false;
  }
  return pool;
}

std::vector<Measurement> only(std::vector<Measurement> measurements, const std::set<std::string>& ids) {
  std::erase_if(measurements, [&](const Measurement& measurement) { return !ids.contains(measurement.id); });
  return measurements;
}

/// Returns all parameters that the drawing leaves open: the cell's free parameters, the geometry, and every stiffness.
FreeChoice allThatIsOpen(const CheckedMeasurements& checked) {
  FreeChoice open = checked.free;
  open.base = true;  // frees base poses that are not known
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  PlacedArm placed = checked.start;
  for (const auto& unknown : chooseUnknowns(placed, checked.free).list)
    if (unknown.owner == Unknown::Owner::kArm) add(unknown.name);
  for (const auto& parameter : deflection::parametersOf(checked.start.arm))
    if (parameter.path.effect < 0 && deflection::isStiffness(parameter.quantity) &&
        parameter.quantity != deflection::Quantity::kPressure)
      add(parameter.name);
  std::erase_if(names, [&](const std::string& name) {
    const auto geometry = namesBehind(checked.start.arm, "geometry");
    return std::ranges::find(geometry, name) != geometry.end();
  });
  names.push_back("geometry");
  open.names = names;
  return open;
}

double shiftOf(const PlacedArm& found, const PlacedArm& nominal, std::size_t p) {
  return (found.base_poses[p].X_WB.translation() - nominal.base_poses[p].X_WB.translation()).norm();
}

double turnOf(const PlacedArm& found, const PlacedArm& nominal, std::size_t p) {
  const Eigen::Matrix3d turn = found.base_poses[p].X_WB.linear() * nominal.base_poses[p].X_WB.linear().transpose();
  return Eigen::AngleAxisd(turn).angle();
}

/// Returns the root-mean-square spread of points [m]; 0 if there are fewer than two.
double spreadOf(const std::vector<Eigen::Vector3d>& points) {
  if (points.size() < 2) return 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& point : points) mean += point / static_cast<double>(points.size());
  double sum = 0;
  for (const auto& point : points) sum += (point - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// Returns the root-mean-square spread of tips that touched unknown points [m]; 0 if there are fewer than two. A
/// correction that contracts these tips lowers their error even if it is wrong.
double extentOfTips(const PlacedArm& placed, const std::vector<Measurement>& measurements) {
  std::vector<Eigen::Vector3d> tips;
  for (const auto& measurement : measurements)
    if (touchesUnknownPoint(measurement))
      if (const auto tip = predictMeasurement(placed, measurement); tip.ok) tips.push_back(tip.value);
  return spreadOf(tips);
}

double spreadOfPlaces(const std::vector<Measurement>& measurements) {
  std::vector<Eigen::Vector3d> places;
  for (const auto& measurement : measurements)
    if (statesPlace(measurement)) places.push_back(*measurement.p_W);
  return spreadOf(places);
}

}  // namespace

MistakeTrials::MistakeTrials(const CheckedMeasurements& checked, const CheckOptions& options)
    : checked_(checked),
      options_(options),
      pool_(poolOf(checked.measurements, options)),
      open_(allThatIsOpen(checked)),
      drawn_{{"tool.tip"}, true, checked.free.priors},
      held_{{}, true, checked.free.priors},
      reach_(deflection::reachOf(checked.start.arm)),
      has_places_(std::ranges::any_of(
          checked.measurements, [](const Measurement& measurement) { return statedPlace(measurement).has_value(); })) {
  if (checked.measurements.empty()) return;
  as_is_ = tried({}, TrialDepth::kOpen);
  const Trial drawn = tried({}, TrialDepth::kDrawn);
  as_is_.error = drawn.error;
  const Trial held = tried({}, TrialDepth::kHeld);
  as_is_.held_error = held.error;
  // Neither displacement of the base is reliable alone. If all open parameters are free, they absorb part of it; with
  // few measurements, a free tip does too. With the nominal tip, on the other hand, a wrong tip displaces the base.
  // Therefore use the smaller of the two displacements.
  const Trial& nearer = held.ok && (!drawn.ok || held.base_shift < drawn.base_shift) ? held : drawn;
  as_is_.base_shift = nearer.base_shift;
  as_is_.base_turn = nearer.base_turn;
}

const FreeChoice& MistakeTrials::freeAt(TrialDepth depth) const {
  return depth == TrialDepth::kOpen ? open_ : depth == TrialDepth::kDrawn ? drawn_ : held_;
}

/// Fits the measurements with the parameters `free`, as far as a fit of this depth needs.
RobustFit MistakeTrials::fit(PlacedArm start, const std::vector<Measurement>& measurements, TrialDepth depth,
                             const FreeChoice& free) const {
  RobustFitOptions options;
  options.free = free;
  options.most_steps = depth == TrialDepth::kOpen ? 8 : 5;
  options.judges_noise = depth == TrialDepth::kOpen;
  options.stop = options_.stop;
  return fitRobustly(std::move(start), measurements, options);
}

std::vector<Measurement> MistakeTrials::corrected(const Correction& correction, TrialDepth depth) const {
  auto measurements = pool_.measurements;
  correction.apply(measurements);
  return only(std::move(measurements), depth == TrialDepth::kOpen ? pool_.counted : pool_.counted_quickly);
}

PlacedArm MistakeTrials::startOf(const Correction& correction) const {
  PlacedArm start = checked_.start;
  if (correction.frees_base)
    for (auto& base_pose : start.base_poses) base_pose.is_known = false;
  if (correction.new_setup) {
    const auto within = std::ranges::find(start.base_poses, correction.new_setup->within, &BasePose::setup);
    start.base_poses.push_back({correction.new_setup->name, within->X_WB, false});
  }
  return start;
}

Trial MistakeTrials::tried(const Correction& correction, TrialDepth depth) const {
  if (correction.parts_setups) return triedPerSetup(depth);
  const PlacedArm start = startOf(correction);
  const auto measurements = corrected(correction, depth);
  return judged(fit(start, measurements, depth, freeAt(depth)), start, measurements);
}

Trial MistakeTrials::judged(const RobustFit& fit, const PlacedArm& nominal,
                            const std::vector<Measurement>& measurements) const {
  if (!fit.ok) return {};
  Trial trial{fit};
  trial.open_error = fit.error;
  for (std::size_t p = 0; p < fit.placed.base_poses.size(); ++p) {
    const double shift = shiftOf(fit.placed, nominal, p), turn = turnOf(fit.placed, nominal, p);
    trial.lack_of_fit += 3.5 * std::log1p(std::pow(shift / (kUsualShift * reach_), 2) + std::pow(turn / kUsualTurn, 2));
    trial.base_shift = std::max(trial.base_shift, shift);
    trial.base_turn = std::max(trial.base_turn, turn);
  }
  trial.extent = extentOfTips(fit.placed, measurements);
  return trial;
}

/// Fits each set-up separately, with a separate tip.
Trial MistakeTrials::triedPerSetup(TrialDepth depth) const {
  Trial combined;
  combined.ok = true;
  combined.lack_of_fit = 0;
  double squares = 0;
  std::size_t count = 0;
  for (const auto& base_pose : checked_.start.base_poses) {
    auto measurements = only(pool_.measurements, depth == TrialDepth::kOpen ? pool_.counted : pool_.counted_quickly);
    std::erase_if(measurements, [&](const Measurement& measurement) { return measurement.setup != base_pose.setup; });
    if (measurements.empty()) continue;
    PlacedArm alone = checked_.start;
    alone.base_poses = {base_pose};
    const Trial part = judged(fit(alone, measurements, depth, freeAt(depth)), alone, measurements);
    if (!part.ok) return part;
    combined.lack_of_fit += part.lack_of_fit;
    squares += part.error * part.error * static_cast<double>(measurements.size());
    count += measurements.size();
  }
  combined.error = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count, 1)));
  combined.extent = as_is_.extent;
  combined.base_shift = as_is_.base_shift;
  combined.base_turn = as_is_.base_turn;
  return combined;
}

RobustFit MistakeTrials::fitZeros(const Correction& correction, PlacedArm start,
                                  const std::vector<std::string>& zeros) const {
  FreeChoice free = held_;
  for (const auto& zero : zeros) {
    free.names.push_back(zero);
    free.priors.named[zero] = std::numbers::pi;
  }
  return fit(std::move(start), corrected(correction, TrialDepth::kDrawn), TrialDepth::kHeld, free);
}

Trial MistakeTrials::triedBy(PlacedArm drawing) const {
  RobustFitOptions options;
  options.free = drawn_;
  options.stop = options_.stop;
  const auto measurements = only(pool_.measurements, pool_.counted);
  return judged(fitRobustly(std::move(drawing), measurements, options), checked_.start, measurements);
}

Trial MistakeTrials::triedWith(const deflection::Effect& effect, TrialDepth depth) const {
  PlacedArm start = checked_.start;
  start.arm.effects.push_back(effect);
  FreeChoice free = freeAt(depth);
  for (const auto& parameter : kindOf(effect).parameters)
    free.names.push_back(deflection::textOf(start.arm, effect) + "." + parameter.name);
  const auto measurements = corrected({}, depth);
  return judged(fit(std::move(start), measurements, depth, free), checked_.start, measurements);
}

int MistakeTrials::freedom(const Correction& correction, TrialDepth depth) const {
  PlacedArm start = startOf(correction);
  const auto found = chooseUnknowns(start, freeAt(depth)).list.size();
  const auto measurements = corrected(correction.parts_setups ? Correction{} : correction, depth);
  return numbersMeasured(measurements) - static_cast<int>(found) - correction.numbers_fitted;
}

double MistakeTrials::noise(const Correction& correction) const {
  double squares = 0;
  const auto measurements = corrected(correction, TrialDepth::kOpen);
  for (const auto& measurement : measurements) squares += rowsOf(measurement) * measurement.sigma * measurement.sigma;
  return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, measurements.size())));
}

double MistakeTrials::shrinkage(const Trial& trial) const {
  return as_is_.extent > 0 && trial.extent > 0 ? std::max(1., as_is_.extent / trial.extent) : 1;
}

double MistakeTrials::contraction(const Correction& correction) const {
  const double corrected_spread = spreadOfPlaces(corrected(correction, TrialDepth::kOpen));
  return corrected_spread > 0 ? std::max(1., spreadOfPlaces(corrected({}, TrialDepth::kOpen)) / corrected_spread) : 1;
}

double MistakeTrials::gain(const Trial& trial) const {
  constexpr double kALot = 1e9;
  if (!as_is_.ok) return kALot - trial.lack_of_fit;
  double rows = 0;
  if (shrinkage(trial) > 1) rows = 3 * static_cast<double>(pool_.counted.size());
  return as_is_.lack_of_fit - trial.lack_of_fit - rows * std::log(shrinkage(trial));
}

bool MistakeTrials::isBaseFar(const Trial& trial) const {
  return has_places_ && (trial.base_turn > kFarTurn || trial.base_shift > kFarShift * reach_);
}

}  // namespace tubeplan::calibration
