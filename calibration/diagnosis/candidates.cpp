#include "calibration/diagnosis/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "calibration/reading_prediction.hpp"

namespace tubeplan::calibration {

using deflection::EffectKind, deflection::Quantity;
using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// What the readings lack for an effect to be seen; empty where nothing.
std::string lackOf(const EffectKind& kind, const std::vector<Measurement>& readings) {
  const auto any = [&](auto&& holds) { return std::any_of(readings.begin(), readings.end(), holds); };
  if (kind.needs.senses && !any([](const Measurement& m) {
        return std::any_of(m.senses.begin(), m.senses.end(), [](int s) { return s != 0; });
      }))
    return "the readings do not say the sense of the joints' last motion (<joint>_dir)";
  if (kind.needs.temperature && !any([](const Measurement& m) { return std::isfinite(m.temperature); }))
    return "the readings do not say the temperature";
  if (kind.needs.time && !any([](const Measurement& m) { return std::isfinite(m.time); }))
    return "the readings do not say the time";
  if (kind.needs.load && !any([](const Measurement& m) { return m.load > 0; })) return "no reading is under a load";
  return "";
}

/// Evenly spread quantiles of the inner part of a sample, doubles once.
std::vector<double> quantiles(std::vector<double> sample, int count, double from, double to) {
  if (sample.empty()) return {};
  std::sort(sample.begin(), sample.end());
  std::set<double> levels;
  for (int k = 0; k < count; ++k) {
    const double share = from + (to - from) * (count > 1 ? static_cast<double>(k) / (count - 1) : 0.5);
    levels.insert(sample[static_cast<std::size_t>(share * static_cast<double>(sample.size() - 1))]);
  }
  return {levels.begin(), levels.end()};
}

/// Moments about an axis at all readings [N m].
std::vector<double> momentsAt(const PlacedArm& placed, const std::vector<Measurement>& readings,
                              const deflection::Place& place) {
  std::vector<double> moments;
  for (const auto& reading : readings) {
    const auto& X_WB = placed.placings[static_cast<std::size_t>(placingOf(placed, reading))].X_WB;
    const auto shape = deflection::solveFlexibleKinematics(placed.arm, postureOf(reading, placed.arm, X_WB));
    moments.push_back(std::abs(shape.rows[static_cast<std::size_t>(place.row)].moment_L[place.axis]));
  }
  return moments;
}

/// Midpoints between the times of readings: a step between two readings looks the same wherever it is.
std::vector<double> timesBetween(const std::vector<Measurement>& readings) {
  std::set<double> times;
  for (const auto& reading : readings)
    if (std::isfinite(reading.time)) times.insert(reading.time);
  std::vector<double> between;
  for (auto at = times.begin(); at != times.end() && std::next(at) != times.end(); ++at)
    between.push_back((*at + *std::next(at)) / 2);
  return between;
}

std::vector<double> levelsOf(const Candidate& candidate, const PlacedArm& placed,
                             const std::vector<Measurement>& readings, const CatalogueOptions& options) {
  if (candidate.shape < 0) return {0};
  const auto& parameter = deflection::effectKinds()[static_cast<std::size_t>(candidate.neutral.kind)]
                              .parameters[static_cast<std::size_t>(candidate.shape)];
  if (parameter.quantity == Quantity::kTorque)
    return quantiles(momentsAt(placed, readings, candidate.neutral.place), options.knee_levels, 0.04, 0.9);
  if (parameter.quantity == Quantity::kTime) return quantiles(timesBetween(readings), options.time_levels, 0.05, 0.95);
  return {parameter.neutral};
}

bool isThereAlready(const deflection::Arm& arm, const deflection::Effect& effect) {
  return std::any_of(arm.effects.begin(), arm.effects.end(), [&](const deflection::Effect& present) {
    return present.kind == effect.kind && present.place == effect.place;
  });
}

Candidate candidateOf(const deflection::Arm& arm, const EffectKind& kind, const deflection::Effect& neutral,
                      const std::string& at) {
  Candidate candidate;
  candidate.effect = kind.name;
  candidate.at = at;
  candidate.neutral = neutral;
  for (int v = 0; v < static_cast<int>(kind.parameters.size()); ++v) {
    const auto number = deflection::numberOf(arm, neutral, v);
    (kind.parameters[static_cast<std::size_t>(v)].is_shape ? (candidate.shape = v, void())
                                                           : candidate.sizes.push_back(v));
    candidate.unit.push_back(kind.parameters[static_cast<std::size_t>(v)].plausible);
    candidate.lower.push_back(number.lower);
    candidate.upper.push_back(number.upper);
  }
  return candidate;
}

/// Columns of effects that an arm carries, whitened, for changes of their values by a unit.
MatrixXd effectColumns(const PlacedArm& placed, const std::vector<Measurement>& readings, const ReadingWeights& weights,
                       const std::vector<Unknown>& unknowns) {
  const auto residual =
      whitenedResidual(placed, unknowns, readings, weights, VectorXd::Zero(static_cast<Index>(unknowns.size())), true);
  if (!residual.ok) return {};
  MatrixXd columns = residual.jacobian;
  for (Index k = 0; k < columns.cols(); ++k) columns.col(k) *= unknowns[static_cast<std::size_t>(k)].typical;
  return columns;
}

std::vector<int> allSizes(const Candidate& candidate) {
  std::vector<int> sizes(candidate.sizes.size());
  for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] = static_cast<int>(k);
  return sizes;
}

}  // namespace

bool isStep(const Candidate& candidate) {
  const auto& kind = deflection::effectKinds()[static_cast<std::size_t>(candidate.neutral.kind)];
  return candidate.shape >= 0 && kind.parameters[static_cast<std::size_t>(candidate.shape)].quantity == Quantity::kTime;
}

int placeEffect(deflection::Arm& arm, const Candidate& candidate, double shape) {
  arm.effects.push_back(candidate.neutral);
  if (candidate.shape >= 0) arm.effects.back().values[static_cast<std::size_t>(candidate.shape)] = shape;
  return static_cast<int>(arm.effects.size()) - 1;
}

std::vector<Unknown> effectUnknowns(const deflection::Arm& arm, const Candidate& candidate, int effect,
                                    const std::vector<int>& sizes) {
  std::vector<Unknown> unknowns;
  const auto& kind = deflection::effectKinds()[static_cast<std::size_t>(candidate.neutral.kind)];
  for (const int size : sizes) {
    const int value = candidate.sizes[static_cast<std::size_t>(size)];
    Unknown unknown;
    unknown.name = candidate.effect + "@" + candidate.at + "." + kind.parameters[static_cast<std::size_t>(value)].name;
    unknown.quantity = deflection::numberOf(arm, candidate.neutral, value).quantity;
    unknown.path.effect = effect;
    unknown.path.value = value;
    unknown.start = arm.effects[static_cast<std::size_t>(effect)].values[static_cast<std::size_t>(value)];
    unknown.typical = candidate.unit[static_cast<std::size_t>(value)];
    unknown.prior_sigma = 10 * unknown.typical;
    unknown.lower = candidate.lower[static_cast<std::size_t>(value)] - unknown.start;
    unknown.upper = candidate.upper[static_cast<std::size_t>(value)] - unknown.start;
    unknowns.push_back(unknown);
  }
  return unknowns;
}

StepColumns::StepColumns(const PlacedArm& placed, const std::vector<Measurement>& readings,
                         const ReadingWeights& weights, const Candidate& step)
    : readings_(readings), weights_(weights) {
  PlacedArm with = placed;
  const int effect = placeEffect(with.arm, step, -std::numeric_limits<double>::infinity());
  ReadingWeights apart = weights;  // what points absorb depends on the time
  apart.points.clear();
  always_ = effectColumns(with, readings, apart, effectUnknowns(with.arm, step, effect, allSizes(step)));
}

MatrixXd StepColumns::at(double time) const {
  MatrixXd columns = always_;
  if (columns.cols() == 0) return columns;
  for (std::size_t k = 0; k < readings_.size(); ++k)
    if (readings_[k].time < time) columns.middleRows(weights_.first_row[k], rowsOf(readings_[k])).setZero();
  takePointsOff(weights_, columns);
  return columns;
}

namespace {

/// Columns of candidates that share an arm, level by level: shapes at one place would add up.
void linearizeLevels(const PlacedArm& placed, const std::vector<Measurement>& readings, const ReadingWeights& weights,
                     Catalogue& catalogue, const WorkHooks& hooks) {
  std::size_t most_levels = 0;
  for (const auto& candidate : catalogue.candidates)
    if (!isStep(candidate)) most_levels = std::max(most_levels, candidate.levels.size());
  for (std::size_t level = 0; level < most_levels; ++level) {
    tell(hooks, "catalogue", level, most_levels);
    PlacedArm with = placed;
    std::vector<Unknown> unknowns;
    std::vector<std::pair<int, Index>> owners;
    for (std::size_t c = 0; c < catalogue.candidates.size(); ++c) {
      const Candidate& candidate = catalogue.candidates[c];
      if (level >= candidate.levels.size() || isStep(candidate)) continue;
      const int effect = placeEffect(with.arm, candidate, candidate.levels[level]);
      const auto own = effectUnknowns(with.arm, candidate, effect, allSizes(candidate));
      owners.emplace_back(static_cast<int>(c), static_cast<Index>(unknowns.size()));
      unknowns.insert(unknowns.end(), own.begin(), own.end());
    }
    const MatrixXd columns = effectColumns(with, readings, weights, unknowns);
    if (columns.cols() == 0) continue;
    for (const auto& [c, first] : owners) {
      const auto count = static_cast<Index>(catalogue.candidates[static_cast<std::size_t>(c)].sizes.size());
      catalogue.columns.push_back({c, static_cast<int>(level), columns.middleCols(first, count)});
    }
  }
}

void linearizeSteps(const PlacedArm& placed, const std::vector<Measurement>& readings, const ReadingWeights& weights,
                    Catalogue& catalogue, const StopQuestion& stop) {
  for (std::size_t c = 0; c < catalogue.candidates.size(); ++c) {
    const Candidate& candidate = catalogue.candidates[c];
    if (!isStep(candidate)) continue;
    goOn(stop);
    const StepColumns columns(placed, readings, weights, candidate);
    for (std::size_t level = 0; level < candidate.levels.size(); ++level)
      catalogue.columns.push_back({static_cast<int>(c), static_cast<int>(level), columns.at(candidate.levels[level])});
  }
}

}  // namespace

Catalogue linearizeCatalogue(const PlacedArm& placed, const std::vector<Measurement>& readings,
                             const ReadingWeights& weights, const CatalogueOptions& options, const WorkHooks& hooks) {
  Catalogue catalogue;
  for (const auto& kind : deflection::effectKinds()) {
    if (const std::string lack = lackOf(kind, readings); !lack.empty()) {
      catalogue.not_tried.push_back(std::string(kind.name) + ": " + lack);
      continue;
    }
    for (const std::string& at : deflection::placeTexts(placed.arm, kind)) {
      goOn(hooks.stop);
      const auto made = deflection::makeEffect(placed.arm, kind.name, at);
      if (isThereAlready(placed.arm, made.effect)) continue;
      catalogue.candidates.push_back(candidateOf(placed.arm, kind, made.effect, at));
      catalogue.candidates.back().levels = levelsOf(catalogue.candidates.back(), placed, readings, options);
    }
  }
  linearizeLevels(placed, readings, weights, catalogue, hooks);
  linearizeSteps(placed, readings, weights, catalogue, hooks.stop);
  return catalogue;
}

}  // namespace tubeplan::calibration
