#include "calibration/diagnosis/discrimination/alternative_measurements.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/resized.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::calibration {

using deflection::EffectStage;
using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

constexpr std::size_t kMostCandidates = 24;
constexpr double kTilt = 20 * std::numbers::pi / 180;  // tilt of the base in another set-up [rad]
// Assumed load, relative to the arm's weight, if no measurement has a load yet.
constexpr double kUnknownLoad = 0.25;
constexpr double kSigmaStep = 1e-3;  // step of a difference quotient, relative to the unknown's standard deviation

std::vector<MeasurementCandidate> thinnedOut(const std::vector<MeasurementCandidate>& candidates) {
  std::vector<MeasurementCandidate> some;
  const std::size_t step = std::max<std::size_t>(1, candidates.size() / kMostCandidates);
  for (std::size_t k = 0; k < candidates.size() && some.size() < kMostCandidates; k += step)
    some.push_back(candidates[k]);
  return some;
}

/// Returns the smallest expected criterion difference between two rivals after up to `options.count` of these
/// candidates, chosen greedily, are measured.
double bestOf(const std::vector<RivalModel>& rivals, const std::vector<RivalPrediction>& predictions,
              const DiscriminationOptions& options) {
  return leastExpected(rivals, predictions,
                       chooseDiscriminating(rivals, predictions, options.count, options.hooks.stop));
}

template <class Change>
std::vector<MeasurementCandidate> changed(std::vector<MeasurementCandidate> candidates, Change change) {
  for (auto& candidate : candidates)
    for (auto& measurement : candidate.measurements) change(measurement);
  return candidates;
}

/// Returns the rivals with an additional tilted base pose and its six unknowns.
std::vector<RivalModel> placedAgain(std::vector<RivalModel> rivals) {
  for (RivalModel& rival : rivals) {
    auto& base_poses = rival.model.placed.base_poses;
    BasePose another = base_poses.back();
    another.setup += " again";
    another.X_WB.rotate(Eigen::AngleAxisd(kTilt, Vector3d::UnitX()));
    base_poses.push_back(another);
    const Index n = rival.covariance.rows();
    for (int k = 0; k < 6; ++k) {
      Unknown unknown;
      unknown.owner = Unknown::Owner::kBase;
      unknown.base_pose = static_cast<int>(base_poses.size()) - 1;
      unknown.component = k;
      rival.model.unknowns.push_back(unknown);
    }
    const MatrixXd before = rival.covariance;
    const double reach = deflection::reachOf(rival.model.placed.arm);
    deflection::takeSized(rival.covariance, MatrixXd::Identity(n + 6, n + 6));
    rival.covariance.block<3, 3>(n, n) *= reach * reach;
    rival.covariance.topLeftCorner(n, n) = before;
  }
  return rivals;
}

/// Returns the origins of the end frames of all rows, stacked, in the world frame [m]; empty if the shape does not
/// converge.
VectorXd frameOrigins(const PlacedArm& placed, const Measurement& measurement) {
  const auto& X_WB = placed.base_poses.back().X_WB;
  const auto shape = deflection::solveFlexibleKinematics(placed.arm, postureOf(measurement, placed.arm, X_WB));
  if (shape.status != deflection::KinematicsStatus::kConverged) return {};
  const auto frames = deflection::rowFramesInWorld(shape, X_WB);
  VectorXd origins(3 * static_cast<Index>(frames.size()));
  for (std::size_t k = 0; k < frames.size(); ++k)
    origins.segment<3>(3 * static_cast<Index>(k)) = frames[k].translation();
  return origins;
}

struct FrameForecast {
  VectorXd value;
  MatrixXd sensitivity;  ///< derivatives of `value` with respect to the unknowns
};

FrameForecast forecastFrames(const RivalModel& rival, const Measurement& measurement) {
  const auto& model = rival.model;
  FrameForecast forecast{frameOrigins(model.placed, measurement), {}};
  if (forecast.value.size() == 0) return forecast;
  const auto n = static_cast<Index>(model.unknowns.size());
  forecast.sensitivity = MatrixXd::Zero(forecast.value.size(), n);
  for (Index k = 0; k < n; ++k) {
    const Unknown& unknown = model.unknowns[static_cast<std::size_t>(k)];
    double step = kSigmaStep * std::sqrt(rival.covariance(k, k));
    if (step > unknown.upper) step = -step;
    VectorXd x = VectorXd::Zero(n);
    x[k] = step;
    const VectorXd moved = frameOrigins(applied(model.placed, model.unknowns, x), measurement);
    if (moved.size()) forecast.sensitivity.col(k) = (moved - forecast.value) / step;
  }
  return forecast;
}

/// Returns, for every row and candidate, the rivals' predictions of the origin of the row's end frame, in standard
/// deviations of the candidate's first measurement.
std::vector<std::vector<RivalPrediction>> predictFrames(const std::vector<RivalModel>& rivals,
                                                        const std::vector<MeasurementCandidate>& candidates,
                                                        const StopQuestion& stop) {
  const std::size_t rows = rivals.front().model.placed.arm.rows.size();
  std::vector<std::vector<RivalPrediction>> of_row(rows, std::vector<RivalPrediction>(candidates.size()));
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t c) {
    const Measurement measurement = conditionsOf(candidates[c].measurements.front());
    std::vector<FrameForecast> forecasts;
    for (const RivalModel& rival : rivals) {
      if (shouldStop(stop)) return;
      forecasts.push_back(forecastFrames(rival, measurement));
      if (forecasts.back().value.size() == 0) return;
    }
    for (std::size_t row = 0; row < rows; ++row)
      for (const auto& forecast : forecasts) {
        of_row[row][c].value.emplace_back(forecast.value.segment<3>(3 * static_cast<Index>(row)) / measurement.sigma);
        of_row[row][c].sensitivity.emplace_back(forecast.sensitivity.middleRows<3>(3 * static_cast<Index>(row)) /
                                                measurement.sigma);
      }
  });
  throwIfStopped(stop);
  return of_row;
}

/// Returns the description of a direct inspection that would show the effect.
std::string directCheck(const FoundEffect& found) {
  if (!found.frees.empty()) return "measure " + found.at + " by itself";
  switch (kindOf(found.fitted).stage) {
    case EffectStage::kJointReading:
      return "check the reading of " + found.at + " separately (a level or an index on the joint)";
    case EffectStage::kGeometry:
      return "measure " + found.at + " separately (its length, its squareness)";
    case EffectStage::kLoad:
      return "measure the force at " + found.at;
    case EffectStage::kFlexibility:
      return "load " + found.at + " separately and observe it with a dial gauge";
    case EffectStage::kBase:
      return "observe the base with a dial gauge";
    case EffectStage::kMeasurement:
      return "measure a bar of known length";
  }
  return "";
}

void addLinks(const std::vector<RivalModel>& rivals, const std::vector<MeasurementCandidate>& candidates,
              const DiscriminationOptions& options, std::vector<AlternativeMeasurements>& means) {
  const auto of_row = predictFrames(rivals, candidates, options.hooks.stop);
  AlternativeMeasurements best;
  for (std::size_t row = 0; row < of_row.size(); ++row) {
    const double least = bestOf(rivals, of_row[row], options);
    if (!(least > best.least_expected) && std::isfinite(best.least_expected)) continue;
    best = {"measure the " + rivals.front().model.placed.arm.rows[row].name +
                " as well as the tip (a target on it, or a dial gauge as loads change)",
            least};
  }
  means.push_back(best);
}

}  // namespace

std::vector<AlternativeMeasurements> findAlternativeMeasurements(const std::vector<RivalModel>& rivals,
                                                                 const std::vector<Explanation>& explanations,
                                                                 const std::vector<MeasurementCandidate>& candidates,
                                                                 const std::vector<Measurement>& measurements,
                                                                 const DiscriminationOptions& options) {
  const auto some = thinnedOut(candidates);
  std::vector<AlternativeMeasurements> means;
  if (!some.empty()) {
    const auto attempt = [&](const std::string& what, const std::vector<RivalModel>& as, const auto& changes) {
      means.push_back({what, bestOf(as, predictByRivals(as, changes, options.hooks.stop), options)});
    };
    double heaviest = 0;
    for (const auto& measurement : measurements) heaviest = std::max(heaviest, measurement.load);
    const double load =
        heaviest > 0 ? 2 * heaviest : kUnknownLoad * deflection::weightOf(rivals.front().model.placed.arm);
    attempt(heaviest > 0 ? "hang a load twice as heavy" : "hang a load on the tip", rivals,
            changed(some, [&](ProposedMeasurement& measurement) { measurement.load = load; }));
    const auto& usual = rivals.front().model.placed.arm.reference;
    for (const auto& kind : deflection::kConditionKinds) {
      if (kind.change == 0) continue;
      attempt(kind.change_words, rivals, changed(some, [&](ProposedMeasurement& measurement) {
                double& value = measurement.conditions[kind.condition];
                value = (std::isfinite(value) ? value : usual[kind.condition]) + kind.change;
              }));
    }
    attempt("set the base up again, tilted by about 20 deg", placedAgain(rivals), some);
    addLinks(rivals, some, options, means);
  }
  std::erase_if(means, [&](const AlternativeMeasurements& mean) {
    return !(mean.least_expected >= separationNeeded(options.required_probability));
  });
  std::ranges::stable_sort(means, std::greater{}, &AlternativeMeasurements::least_expected);
  for (const auto& explanation : explanations)
    for (const auto& effect : explanation.effects) {
      const std::string check = directCheck(effect);
      if (std::ranges::none_of(means, [&](const AlternativeMeasurements& mean) { return mean.what == check; }))
        means.push_back({check, kNotKnown});
    }
  return means;
}

}  // namespace tubeplan::calibration
